// What is measured of arcs, see tb/sim/job_check.h.
#pragma once

#include "model/circular/oracle.h"
#include "tb/designs/circular/design.h"
#include "tb/sim/path_figures.h"

namespace cosim::circular {

struct ArcFigures : PathFigures {
  using Checker = Design::Checker<Word>;
  static constexpr std::size_t first = Checker::size - 3;  // steps, least, most
  void clock(const Params&, const Arc&, const Checker&, const Design::Outputs<Word>& seen) {
    steps += step_of(seen) == Point{} ? 0 : 1;
  }
  void end(const Params&, const Arc& arc, const Checker& checker) {
    const auto c = clocked::object_of<Machine::Checker>(checker);
    for (const auto excess : {static_cast<Word>(c.least), static_cast<Word>(c.most)}) {
      deviates(about_radial_deviation_by(excess, arc.radius2),
               [&] { return radial_deviation_by(excess, arc.radius2); });
    }
  }
  void end_in_lane(const Params& p, const Arc& arc, const Checker& checker) {
    steps += static_cast<std::uint64_t>(clocked::object_of<Machine::Checker>(checker).steps);
    end(p, arc, checker);
  }
};

}  // namespace cosim::circular
