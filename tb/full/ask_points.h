// The points of a design's coverage that no sweep reached, asked of the engine from reset on.
#pragma once

#include "tb/sim/asked.h"

namespace cosim::cli {

/// As Form has it. Of a model that has no nets nothing is asked, and that is printed.
coverage::Answers ask_points(const coverage::Asking& asking, coverage::Points& points);

}  // namespace cosim::cli
