// Random stimuli for a graph: what lies deep is found by chance sooner than by search.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "tb/nets/graph.h"
#include "tb/nets/runs.h"

namespace cosim::proof {

/// 64 runs from the first state, for at most so many clocks: `see` is shown each, and ends them
/// with false. Interrupted (interrupt.h), here and below.
void run_by_chance(const nets::Graph& graph, std::uint64_t seed, std::size_t clocks,
                   const std::function<bool(const nets::Runs&)>& see);

/// 64 runs from the first state, each for at most so many clocks: the inputs of one, a row a clock,
/// until `bad` is 1; none where it never was, or `stop`, asked now and then, said so. `seed` says
/// which runs.
std::vector<std::vector<bool>> by_chance(const nets::Graph& graph, nets::Bit bad,
                                         std::uint64_t seed, std::size_t clocks,
                                         const std::function<bool()>& stop = {});

}  // namespace cosim::proof
