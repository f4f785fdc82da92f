// What is taken of lines and circles in lanes, see tb/bench/lane_jobs.h.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/dda/equation.h"
#include "model/dda/job.h"
#include "tb/bench/lane_jobs.h"
#include "tb/sweep/path_check.h"

namespace cosim::dda {

struct CurveFigures : PathFigures {
  static constexpr std::size_t first = Checker<Word>::index_steps;
  void add(const Params& p, const Job& job, const Checker<Word>& at_end) {
    const Word scale = Word{1} << shifts_of(p, job);
    PathFigures::add({static_cast<std::uint64_t>(at_end.steps),
                      std::max(deviation_by(job, at_end.least / scale),
                               deviation_by(job, at_end.most / scale))});
  }
};
using LaneCurves = LaneJobsOf<Design, CurveFigures>;

}  // namespace cosim::dda
