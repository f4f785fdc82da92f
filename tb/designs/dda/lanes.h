// Lines and circles in lanes, see tb/nets/jobs.h.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/dda/equation.h"
#include "model/dda/host.h"
#include "model/dda/walk.h"
#include "tb/sweep/path_check.h"

namespace cosim::dda {

struct LaneCurves {
  using Design = dda::Design;
  template <class V>
  using Walk = dda::Walk<V>;
  using Figures = PathFigures;

  static constexpr std::size_t figures = Walked<Word>::index_steps;
  static Figures figures_of(const Params&, const Job& job, const Due<Word>& due,
                            const Walked<Word>& at_end) {
    const Word scale = Word{1} << due.shifts;
    return {
        static_cast<std::uint64_t>(at_end.steps),
        std::max(deviation_by(job, at_end.least / scale), deviation_by(job, at_end.most / scale))};
  }
};

}  // namespace cosim::dda
