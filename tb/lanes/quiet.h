// The clocks of jobs on which nobody writes or starts.
#pragma once

#include <optional>

#include "tb/nets/draw.h"

namespace cosim::lanes {

/// Of jobs: a clock on which all pins that follow from the driver's state alone, but that do not
/// always rest, are at rest.
struct Quiet {
  nets::DrawStep loud;  ///< its only input: the clock is none of these
  nets::DrawStep draw;  ///< what draws such a clock
  nets::Answer answer;  ///< and what answers it
};

/// None where there are no jobs, or no such pins.
std::optional<Quiet> quiet_of(const nets::Draw& draw);

}  // namespace cosim::lanes
