// What every adapter of a Verilated class shares. An adapter gives lockstep six things: the design,
// its parameters, and drive(), eval(), outputs(), registers(); the design's field tables write
// them.
#pragma once

#include <verilated.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/core/fields.h"
#include "tb/dut/instance.h"
#include "tb/dut/signal.h"

namespace cosim {

/// The signals of the instance in `context`; those named `clock` carry the clock.
std::vector<Signal> signals_of(VerilatedContext& context, const std::string& clock);

/// Owns one instance of a Verilated class. Its registers power up at random from `power_up`, so
/// that a register that no reset reaches shows. `is_reset`: its inputs can reset it for sure.
/// `restarts`: it may be one that was used before and powers up again.
template <class Top, bool is_reset = true, bool restarts = false>
class VerilatedInstance {
 public:
  explicit VerilatedInstance(std::uint32_t power_up) : machine_(acquire<Top, restarts>(power_up)) {}
  ~VerilatedInstance() { release<Top, restarts>(std::move(machine_), is_reset); }
  VerilatedInstance(const VerilatedInstance&) = delete;
  VerilatedInstance& operator=(const VerilatedInstance&) = delete;

  /// The reset has ended: in a new instance coverage counts anew from here.
  void begin() {
    if constexpr (coverage::measured) machine_->count_from_here();
  }
  /// Powers up again at random from `power_up`; false where that cannot be.
  bool restart(std::uint32_t power_up) { return machine_->restart(power_up); }
  /// Every signal of the hierarchy; empty unless Verilated with --vpi --public-flat-rw.
  std::vector<Signal> signals(const std::string& clock = "clk") const {
    return signals_of(machine_->context(), clock);
  }

 protected:
  VerilatedContext& context() { return machine_->context(); }
  Top& top() { return *top_; }
  const Top& top() const { return *top_; }

 private:
  std::unique_ptr<Instance<Top>> machine_;
  Top* top_ = &machine_->top();
};

}  // namespace cosim
