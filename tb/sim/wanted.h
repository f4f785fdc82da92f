// The wave of a test: if the environment variable COSIM_WAVE names a file, the first machine that
// the process runs is drawn there.
#pragma once

#include <functional>

#include "tb/sim/bench.h"

namespace cosim {

/// Draws the result of `stimulus`, if no machine was drawn before. Costs nothing if no wave is
/// wanted. An error goes to standard error.
void draw_if_wanted(const AnyBench& bench, const std::function<Stimulus()>& stimulus);

}  // namespace cosim
