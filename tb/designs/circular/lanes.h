// Arcs in lanes, see tb/nets/jobs.h.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/circular/oracle.h"
#include "model/circular/walk.h"
#include "tb/sweep/path_check.h"

namespace cosim::circular {

struct LaneArcs {
  using Design = circular::Design;
  template <class V>
  using Walk = circular::Walk<V>;
  using Figures = PathFigures;

  static constexpr std::size_t figures = Walked<Word>::index_least;
  static Figures figures_of(const Params&, const Arc& arc, const Due<Word>& due,
                            const Walked<Word>& at_end) {
    return {static_cast<std::uint64_t>(due.steps),
            std::max(radial_deviation_by(at_end.least, arc.radius2),
                     radial_deviation_by(at_end.most, arc.radius2))};
  }
};

}  // namespace cosim::circular
