// What is taken of arcs in lanes, see tb/bench/lane_jobs.h.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/circular/job.h"
#include "model/circular/oracle.h"
#include "tb/bench/lane_jobs.h"
#include "tb/sweep/path_check.h"

namespace cosim::circular {

struct ArcFigures : PathFigures {
  static constexpr std::size_t first = Checker<Word>::index_steps;
  void add(const Params&, const Arc& arc, const Checker<Word>& at_end) {
    PathFigures::add({static_cast<std::uint64_t>(at_end.steps),
                      std::max(radial_deviation_by(at_end.least, arc.radius2),
                               radial_deviation_by(at_end.most, arc.radius2))});
  }
};
using LaneArcs = LaneJobsOf<Design, ArcFigures>;

}  // namespace cosim::circular
