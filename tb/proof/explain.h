// A counterexample for a person and for the replay.
#pragma once

#include <string>

#include "tb/bench/bench.h"
#include "tb/proof/claims.h"

namespace cosim::proof {

/// Starts from its state, has its inputs for a clock and then a clock at rest, so that what differs
/// after the clock is seen.
Stimulus stimulus_of(const Counterexample& c, const AnyBench& bench);

/// Every signal of it, expected above actual where they differ. Lines end in '\n'.
std::string to_text(const Counterexample& c);

}  // namespace cosim::proof
