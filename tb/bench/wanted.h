// A wave of a test that someone wants to see: where the environment names a file in COSIM_WAVE, the
// first machine that is run in the process is drawn there.
#pragma once

#include <functional>

#include "tb/bench/bench.h"

namespace cosim {

/// Draws what `stimulus` gives, if no machine was drawn before. Costs nothing where no wave is
/// wanted. Says on standard error why it could not.
void draw_if_wanted(const AnyBench& bench, const std::function<Stimulus()>& stimulus);

}  // namespace cosim
