// Makes a failing stimulus smaller, by trying.
#pragma once

#include <chrono>

#include "tb/sim/bench.h"

namespace cosim {

/// The smallest stimulus found within `budget` on which RTL and model still differ: fewer clocks,
/// pins at rest, lower values; it ends with the first clock that differs. `stimulus` fails on
/// `bench`. It does not matter which signal differs first.
Stimulus shrink(const AnyBench& bench, Stimulus stimulus,
                std::chrono::milliseconds budget = std::chrono::seconds(8));

}  // namespace cosim
