// Whole jobs in lanes: each lane has a case, and one that ends it the next on the following clock.
#pragma once

#include "tb/lanes/built.h"
#include "tb/sim/bench.h"
#include "tb/sim/sweep.h"

namespace cosim::lanes {

/// The same sweep in these lanes, made with what draws its jobs, with the same result. Case i is
/// powered up from i. Between two cases a lane is reset in no
/// clock. A case that differs, or that the check finds wrong, is run again by itself: Unconfirmed
/// where that is another clock or finds nothing. All must outlive the sweep.
Sweep job_sweep(const AnyBench& bench, const Built& built, const Sweep& sweep);

}  // namespace cosim::lanes
