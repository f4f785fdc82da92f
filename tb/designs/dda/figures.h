// What is measured of curves, see tb/sim/job_check.h.
#pragma once

#include "model/dda/equation.h"
#include "model/dda/job.h"
#include "model/dda/steps.h"
#include "tb/sweep/path_figures.h"

namespace cosim::dda {

struct CurveFigures : PathFigures {
  static constexpr std::size_t first = Checker<Word>::index_steps;
  void clock(const Params&, const Job& job, const Checker<Word>& c, const Outputs<Word>& seen) {
    if (!seen.busy || step_of(seen) == Point{}) return;
    ++steps;
    if (!is_line_or_circle(job)) deviates(deviation(job, {c.x, c.y}));
  }
  void end(const Params& p, const Job& job, const Checker<Word>& c) {
    if (!is_line_or_circle(job)) return;
    const Word scale = Word{1} << shifts_of(p, job);
    for (const Word twice : {c.least / scale, c.most / scale}) {
      deviates(about_deviation_by(job, twice), [&] { return deviation_by(job, twice); });
    }
  }
  void end_in_lane(const Params& p, const Job& job, const Checker<Word>& c) {
    steps += static_cast<std::uint64_t>(c.steps);
    end(p, job, c);
  }
};

}  // namespace cosim::dda
