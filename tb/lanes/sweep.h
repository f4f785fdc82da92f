// Hostile clocks of a design in lanes: the sweep of one case at a time, many cases at a time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "tb/lanes/built.h"
#include "tb/lanes/gpu.h"
#include "tb/nets/played.h"
#include "tb/proof/yosys.h"
#include "tb/sim/bench.h"
#include "tb/sim/sweep.h"

namespace cosim::lanes {

/// A difference that lockstep does not see: something is wrong with the lanes themselves.
class Unconfirmed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The code of a design's lanes, so many of them, from `folder` where it was kept. InputError, one
/// line, where the design cannot run in lanes or a tool is missing.
std::unique_ptr<Built> built(const std::string& title, const nets::Played& played,
                             const proof::Source& source, int lanes,
                             const std::filesystem::path& folder);

/// The same on a GPU, or another device of OpenCL. InputError where there is none, too.
std::unique_ptr<Gpu> on_gpu(const std::string& title, const nets::Played& played,
                            const proof::Source& source, const std::filesystem::path& folder);

/// The sweep that hostile_sweep() of the bench is, with the same result. A case that differs is run
/// again by the bench: Unconfirmed where that does not find it on the same clock. The bench and
/// `built` must outlive the sweep.
Sweep hostile_sweep(const AnyBench& bench, const Built& built, std::uint64_t seed,
                    std::uint64_t clocks);
Sweep hostile_sweep(const AnyBench& bench, std::shared_ptr<Gpu> gpu, std::uint64_t seed,
                    std::uint64_t clocks);

}  // namespace cosim::lanes
