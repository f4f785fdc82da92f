// What can be swept of every design.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "tb/cli/registry.h"

namespace cosim::cli {

/// What the registered designs add, in their order; then of every other design that is built
/// hostile clocks, and random jobs where it declares its jobs: these need nothing else. They live
/// on.
const std::vector<const DesignSweeps*>& all_sweeps(const Registry& registry);

/// What is to be swept: everything, so many random cases or so many hostile clocks, 0: none.
struct Asked {
  bool exhaustive = false;
  std::uint64_t random = 0, hostile = 0;
  std::uint64_t seed = 1;
  bool lanes = false;  ///< jobs, too, in lanes
};
using Planned = std::vector<std::pair<const AnyBench*, Sweep>>;

/// The sweeps, each with the bench it runs on; none where all are too wide to try everything.
/// InputError where lanes are asked for and jobs have none.
Planned planned(const DesignSweeps& design, const std::vector<const AnyBench*>& benches,
                const Asked& asked);

/// The same sweep, but it ends before the next case when it is interrupted, by Interrupted. `ran`
/// is told what came of cases, from several threads.
Sweep interruptible(const Sweep& sweep, const std::function<void(const Result&)>& ran = {});

}  // namespace cosim::cli
