// What is taken of lines in lanes, see tb/bench/lane_jobs.h.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/linear/job.h"
#include "tb/bench/lane_jobs.h"
#include "tb/sweep/path_check.h"

namespace cosim::linear {

struct LineFigures : PathFigures {
  static constexpr std::size_t first = Checker<Word>::index_words;
  // Every word was as it is due, so their number says what was drawn.
  void add(const Params& p, const Job& job, const Checker<Word>& at_end) {
    PathFigures::add(
        {static_cast<std::uint64_t>(std::min(job.line.major, at_end.words << p.gamma())),
         linear::max_deviation(p.m, job.line.major, job.line.code).value()});
  }
};
using LaneLines = LaneJobsOf<Design, LineFigures>;

}  // namespace cosim::linear
