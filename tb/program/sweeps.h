// What can be swept of every design.
#pragma once

#include <vector>

#include "tb/program/registry.h"

namespace cosim::cli {

/// What the registered designs add, in their order; then of every other design that is built
/// hostile clocks, and random jobs where it declares its jobs: these need nothing else. They live
/// on.
const std::vector<const DesignSweeps*>& all_sweeps(const Registry& registry);

}  // namespace cosim::cli
