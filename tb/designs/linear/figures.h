// What is measured of lines, see tb/sim/job_check.h.
#pragma once

#include <algorithm>

#include "model/linear/job.h"
#include "model/linear/steps.h"
#include "tb/sweep/path_figures.h"

namespace cosim::linear {

struct LineFigures : PathFigures {
  static constexpr std::size_t first = Checker<Word>::index_words;
  void clock(const Params&, const Job&, const Checker<Word>&, const Outputs<Word>& seen) {
    if (seen.strobe) steps += static_cast<std::uint64_t>(way_of(seen).x);
  }
  void end(const Params& p, const Job& job, const Checker<Word>&) {
    deviates(linear::max_deviation(p.m, job.line.major, job.line.code).value());
  }
  // Every word was as it is due, so their number says what was drawn.
  void end_in_lane(const Params& p, const Job& job, const Checker<Word>& c) {
    steps += static_cast<std::uint64_t>(std::min(job.line.major, c.words << p.gamma()));
    end(p, job, c);
  }
};

}  // namespace cosim::linear
