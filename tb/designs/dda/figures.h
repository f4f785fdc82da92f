// What is measured of curves, see tb/sim/job_check.h.
#pragma once

#include "model/dda/equation.h"
#include "tb/designs/dda/design.h"
#include "tb/sim/path_figures.h"

namespace cosim::dda {

struct CurveFigures : PathFigures {
  using Checker = Design::Checker<Word>;
  static constexpr std::size_t first = Checker::size - 3;  // steps, least, most
  void clock(const Params&, const Job& job, const Checker& c, const Design::Outputs<Word>& seen) {
    if (!is_busy(seen) || step_of(seen) == Point{}) return;
    ++steps;
    if (is_line_or_circle(job)) return;
    const auto checker = clocked::object_of<Machine::Checker>(c);
    deviates(deviation(job, {static_cast<Word>(checker.x), static_cast<Word>(checker.y)}));
  }
  void end(const Params& p, const Job& job, const Checker& c) {
    if (!is_line_or_circle(job)) return;
    const auto checker = clocked::object_of<Machine::Checker>(c);
    const Word scale = Word{1} << shifts_of(width_of(p), job);
    for (const auto excess : {static_cast<Word>(checker.least), static_cast<Word>(checker.most)}) {
      const Word twice = excess / scale;
      deviates(about_deviation_by(job, twice), [&] { return deviation_by(job, twice); });
    }
  }
  void end_in_lane(const Params& p, const Job& job, const Checker& c) {
    steps += static_cast<std::uint64_t>(clocked::object_of<Machine::Checker>(c).steps);
    end(p, job, c);
  }
};

}  // namespace cosim::dda
