// Sweeps of the circular machine: whole arcs, checked in lockstep and against the oracle.
#pragma once

#include <cstdint>
#include <vector>

#include "tb/designs/circular/design.h"
#include "tb/sim/bench.h"
#include "tb/sim/sweep.h"

namespace cosim::circular {

using CircularBench = Bench<Design>;

/// Every lattice point of the first quadrant next to the circle, (R, 0) first, (0, R) last.
std::vector<Point> every_start(std::uint64_t radius2);

/// The arc from (R, 0) for every R from `first` to `last`; a case is one R.
Sweep every_radius(const CircularBench& bench, std::int64_t first, std::int64_t last);

/// Every start of every radius up to `last`; a case is one radius.
Sweep every_start(const CircularBench& bench, std::int64_t last);

/// Every start of every radius up to `last`, stopped through input 32 after every number of steps;
/// a case is one radius.
Sweep every_stop(const CircularBench& bench, std::int64_t last);

/// The arc that random case i draws: any radius of the width, whole or not, any start, a fourth of
/// them just before the sector change; stopped early where it is long.
Arc random_arc(int width, std::uint64_t seed, std::uint64_t i);

/// `count` random arcs; a case is one arc.
Sweep random_arcs(const CircularBench& bench, std::uint64_t seed, std::uint64_t count);

}  // namespace cosim::circular
