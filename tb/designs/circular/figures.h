// What is measured of arcs, see tb/bench/job_check.h.
#pragma once

#include "model/circular/job.h"
#include "model/circular/oracle.h"
#include "model/circular/steps.h"
#include "tb/sweep/path_figures.h"

namespace cosim::circular {

struct ArcFigures : PathFigures {
  static constexpr std::size_t first = Checker<Word>::index_steps;
  void clock(const Params&, const Arc&, const Checker<Word>&, const Outputs<Word>& seen) {
    steps += step_of(seen) == Point{} ? 0 : 1;
  }
  void end(const Params&, const Arc& arc, const Checker<Word>& c) {
    for (const Word excess : {c.least, c.most}) {
      deviates(about_radial_deviation_by(excess, arc.radius2),
               [&] { return radial_deviation_by(excess, arc.radius2); });
    }
  }
  void end_in_lane(const Params& p, const Arc& arc, const Checker<Word>& c) {
    steps += static_cast<std::uint64_t>(c.steps);
    end(p, arc, c);
  }
};

}  // namespace cosim::circular
