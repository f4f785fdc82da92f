// RTL and model in lockstep, at work.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "tb/sim/bench.h"

namespace cosim {

template <class Design>
class Loop {
 public:
  virtual ~Loop() = default;
  /// Clocks through the inputs of the host or the stimulus, to their end (true) or to the first
  /// difference (false). Adds the clocks, the differing one included, to `clocks`.
  virtual bool through(HostOf<Design>& host, Observer<Design>& observer, std::uint64_t& clocks) = 0;
  virtual bool through(HostileStimulus<Design>& hostile, std::uint64_t& clocks) = 0;
  /// So far, as of a Run.
  virtual std::vector<std::uint64_t> left_out() const = 0;
};

/// Makes one that has just been reset.
template <class Design>
using LoopMaker =
    std::function<std::unique_ptr<Loop<Design>>(const DutMaker<Design>&, std::uint32_t power_up)>;

template <class Adapter>
class AdapterLoop final : public Loop<typename Adapter::Design> {
  using Design = typename Adapter::Design;

 public:
  template <class PowerUp>
  explicit AdapterLoop(const PowerUp& power_up) : lockstep_(power_up) {}
  bool through(HostOf<Design>& host, Observer<Design>& observer, std::uint64_t& clocks) override {
    return clock_fast(lockstep_, host, clocks,
                      [&](const auto& h, const auto& seen) { observer.clock(h.job(), seen); });
  }
  bool through(HostileStimulus<Design>& hostile, std::uint64_t& clocks) override {
    return clock_fast(lockstep_, hostile, clocks, [](const auto&, const auto&) {});
  }
  std::vector<std::uint64_t> left_out() const override { return lockstep_.mask().left_out(); }

 private:
  Lockstep<Adapter> lockstep_;
};

/// For short runs: compiled once for a design.
template <class Design>
std::unique_ptr<Loop<Design>> short_loop(const DutMaker<Design>& dut, std::uint32_t power_up) {
  using Any = AnyAdapter<Design>;
  return std::make_unique<AdapterLoop<Any>>(typename Any::PowerUp{dut, power_up});
}
/// For long runs: compiled for this adapter.
template <class Adapter>
std::unique_ptr<Loop<typename Adapter::Design>> fast_loop(
    const DutMaker<typename Adapter::Design>& /*dut*/, std::uint32_t power_up) {
  return std::make_unique<AdapterLoop<Adapter>>(power_up);
}

}  // namespace cosim
