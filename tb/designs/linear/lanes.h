// Lines in lanes, see tb/nets/jobs.h.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/linear/host.h"
#include "model/linear/walk.h"
#include "tb/sweep/path_check.h"

namespace cosim::linear {

struct LaneLines {
  using Design = linear::Design;
  template <class V>
  using Walk = linear::Walk<V>;
  using Figures = PathFigures;

  static constexpr std::size_t figures = Walked<Word>::index_words;
  // Every word was as it is due, so their number says what was drawn.
  static Figures figures_of(const Params& p, const Job& job, const Due<Word>&,
                            const Walked<Word>& at_end) {
    return {static_cast<std::uint64_t>(std::min(job.line.major, at_end.words << p.gamma())),
            max_deviation(p.m, job.line.major, job.line.code).value()};
  }
};

}  // namespace cosim::linear
