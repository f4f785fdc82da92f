// A counterexample for a person and for the replay.
#pragma once

#include <string>

#include "tb/bench/bench.h"
#include "tb/proof/claims.h"
#include "tb/proof/counterexample.h"

namespace cosim::proof {

/// Starts from its state, applies its inputs for one clock and then one idle clock, so that a
/// difference after the clock shows.
Stimulus stimulus_of(const Counterexample& c, const AnyBench& bench);

/// Every signal of it, expected above actual where they differ. Lines end in '\n'.
std::string to_text(const Counterexample& c);

}  // namespace cosim::proof
