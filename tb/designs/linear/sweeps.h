// Sweeps of the linear machine: whole lines, checked in lockstep and against the oracle.
#pragma once

#include <cstdint>

#include "tb/designs/linear/design.h"
#include "tb/sim/bench.h"
#include "tb/sim/sweep.h"

namespace cosim::linear {

using LinearBench = Bench<Design>;

/// Every BP with every UK; a case is one BP. For m <= 12.
Sweep every_line(const LinearBench& bench);

/// The line that random case i draws: BP and UK of all sizes and shapes, a fourth of the codes the
/// best ones for a random MP. A line of more than 2000 words is given up after a random number.
Job random_line(const Params& p, std::uint64_t seed, std::uint64_t i);

/// `count` random lines; a case is one line.
Sweep random_lines(const LinearBench& bench, std::uint64_t seed, std::uint64_t count);

}  // namespace cosim::linear
