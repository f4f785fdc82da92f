// Whole jobs in lanes: each lane has a case, and one that ends it the next on the following clock.
#pragma once

#include <filesystem>
#include <memory>

#include "tb/bench/bench.h"
#include "tb/lanes/built.h"
#include "tb/nets/played.h"
#include "tb/proof/rtl.h"
#include "tb/sweep/sweep.h"

namespace cosim::lanes {

/// As built() of hostile clocks, for the jobs of a sweep that has them in lanes. InputError too
/// where a register comes out of a reset as it powered up.
std::unique_ptr<Built> built_for_jobs(const AnyBench& bench, nets::Played played,
                                      const proof::Source& source, const LaneJobs& jobs, int lanes,
                                      const std::filesystem::path& folder);

/// The same sweep in these lanes, with the same result. Between two cases a lane is reset in no
/// clock. A case that differs, or that the check finds wrong, is run again by itself: Unconfirmed
/// where that is another clock or finds nothing. All must outlive the sweep.
Sweep job_sweep(const AnyBench& bench, const Built& built, const Sweep& sweep);

}  // namespace cosim::lanes
