// What is measured of lines, see tb/sim/job_check.h.
#pragma once

#include <algorithm>
#include <bit>

#include "tb/designs/linear/design.h"
#include "tb/sim/path_figures.h"

namespace cosim::linear {

struct LineFigures : PathFigures {
  using Checker = Design::Checker<Word>;
  static constexpr std::size_t first = Checker::size - 1;  // words
  void clock(const Params&, const Job&, const Checker&, const Design::Outputs<Word>& seen) {
    const auto out = out_of(seen);
    if (out.strobe) steps += std::uint64_t(std::popcount(static_cast<std::uint64_t>(out.major)));
  }
  void end(const Params& p, const Job& job, const Checker&) {
    deviates(linear::max_deviation(sizes_of(p).m, job.line.major, job.line.code).value());
  }
  // Every word was as it is due, so their number says what was drawn.
  void end_in_lane(const Params& p, const Job& job, const Checker& c) {
    const Word words = to_words(c)[first];
    steps += static_cast<std::uint64_t>(std::min(job.line.major, words << sizes_of(p).gamma()));
    end(p, job, c);
  }
};

}  // namespace cosim::linear
