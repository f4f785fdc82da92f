// The sweeps that run in lanes: made when they begin, or prepared once for all nodes of a
// regression.
#pragma once

#include <cstdint>
#include <filesystem>

#include "tb/cli/command.h"
#include "tb/sim/sweep.h"

namespace cosim::cli {

/// As Form has it.
Sweep in_lanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t seed, std::uint64_t clocks,
               const Text& lanes);

/// The sweep in the widest lanes of the folder `prepared` that this processor runs; as it was where
/// there are none. `clocks`: of hostile ones, 0 of another sweep.
Sweep in_prepared_lanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t seed,
                        std::uint64_t clocks, const std::filesystem::path& prepared);

/// Makes in the folder `prepared` the lanes that in_prepared_lanes() takes there, for this
/// processor, or for any that has vectors no wider. Hostile clocks get them where they are worth
/// it, jobs where they are `asked` for. InputError where what is asked for is not to be had.
void prepare_lanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t clocks, bool asked,
                   bool for_any, const std::filesystem::path& prepared);

}  // namespace cosim::cli
