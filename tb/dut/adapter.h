// What every adapter of a Verilated class shares. An adapter gives lockstep six things: the design,
// its parameters, and drive(), eval(), outputs(), registers(); the design's field tables write
// them.
#pragma once

#include <verilated.h>
#include <verilated_cov.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "model/core/fields.h"
#include "tb/dut/counts.h"
#include "tb/dut/port_net.h"
#include "tb/show/signal.h"

namespace cosim {

/// One instance of any class at a time powers up.
inline std::mutex seeding;

/// One instance of a Verilated class in a context of its own.
template <class Top>
class Instance {
 public:
  /// Registers power up at random from `power_up`.
  explicit Instance(std::uint32_t power_up) {
    context_->threads(1);
    context_->randReset(2);
    const auto seeded = seed(power_up);
    top_ = std::make_unique<Top>(context_.get(), "TOP");
  }
  ~Instance() {
    // The class takes its scopes from the context of the thread. That was set by the instance built
    // last, which may be gone by now.
    ::Verilated::threadContextp(context_.get());
    top_->final();
    top_.reset();
  }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  /// Makes of it what a new instance from `power_up` is, in a hundredth of the time. False, and it
  /// stays what it is, where its class has state that is not known to come back (ports.cmake), and
  /// where it counts coverage.
  bool restart(std::uint32_t power_up) {
    if constexpr (coverage::measured || !can_power_up<Top>) {
      return false;
    } else {
      ::Verilated::threadContextp(context_.get());
      top_->final();
      const auto seeded = seed(power_up);
      power_up_again(*top_);
      return true;
    }
  }

  VerilatedContext& context() { return *context_; }
  Top& top() { return *top_; }

  /// The first call of it writes the counts of coverage that there are, and takes them back to 0.
  void count_from_here() {
    if (!std::exchange(is_new_, false)) return;
    leave_counts("before.");
    context_->coveragep()->zero();
  }
  /// Writes the counts of coverage to a file of their own, whose name begins so.
  void leave_counts(const std::string& begins) {
    static std::atomic<int> number{0};
    const std::string path = coverage::file_for(begins + top_->modelName(), number++);
    if (!path.empty()) context_->coveragep()->write(path.c_str());
  }

 private:
  // A new seed makes Verilator begin its random numbers anew on all threads, so that nobody else
  // may set one until the registers have theirs.
  [[nodiscard]] std::unique_lock<std::mutex> seed(std::uint32_t power_up) {
    std::unique_lock lock(seeding);
    context_->randSeed(static_cast<int>(power_up & 0x7fffffffU) | 1);
    return lock;
  }

  bool is_new_ = true;
  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Top> top_;
};

/// Instances that are no longer used. To make a context and an instance takes as long as thousands
/// of clocks. Where coverage is measured, Verilator counts it in each instance: those write their
/// counts when the process ends; one of a design that no input resets cannot be used again, and
/// writes them at once.
template <class Top>
class SpareInstances {
 public:
  static SpareInstances& instance() {
    if constexpr (coverage::measured) {
      static SpareInstances all;
      return all;
    } else {
      // Never destroyed: as a process ends, Verilator's tables may go before the instances.
      static auto* const all = new SpareInstances;
      return *all;
    }
  }
  std::unique_ptr<Instance<Top>> take() {
    const std::lock_guard lock(guard_);
    if (spare_.empty()) return {};
    auto machine = std::move(spare_.back());
    spare_.pop_back();
    return machine;
  }
  void give(std::unique_ptr<Instance<Top>> machine) {
    if constexpr (coverage::measured) machine->count_from_here();
    const std::lock_guard lock(guard_);
    spare_.push_back(std::move(machine));
  }
  ~SpareInstances() {
    if constexpr (coverage::measured) {
      for (const auto& machine : spare_) machine->leave_counts("");
    }
  }

 private:
  std::mutex guard_;
  std::vector<std::unique_ptr<Instance<Top>>> spare_;
};

/// Whether instances are kept: of those that `restarts` where they can be made as new.
template <class Top, bool restarts>
inline constexpr bool are_kept = coverage::measured || (restarts && can_power_up<Top>);

/// A machine to use. When coverage is measured, its registers may hold values of an earlier use in
/// place of those from `power_up`.
template <class Top, bool restarts>
std::unique_ptr<Instance<Top>> acquire(std::uint32_t power_up) {
  if constexpr (are_kept<Top, restarts>) {
    auto spare = SpareInstances<Top>::instance().take();
    if (spare && (coverage::measured || spare->restart(power_up))) return spare;
  }
  return std::make_unique<Instance<Top>>(power_up);
}

/// To be called when a machine is no longer used; `again`: it may be used again where coverage is
/// measured.
template <class Top, bool restarts>
void release([[maybe_unused]] std::unique_ptr<Instance<Top>> machine, [[maybe_unused]] bool again) {
  if constexpr (are_kept<Top, restarts>) {
    if (coverage::measured && !again) return machine->leave_counts("");
    SpareInstances<Top>::instance().give(std::move(machine));
  }
}

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
