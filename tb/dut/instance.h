// One instance of a Verilated class in a context of its own.
#pragma once

#include <verilated.h>
#include <verilated_cov.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "tb/coverage/counts.h"

namespace cosim {

template <class Top>
class Instance {
 public:
  /// Registers power up at random from `power_up`.
  explicit Instance(std::uint32_t power_up) {
    context_->threads(1);
    context_->randReset(2);
    context_->randSeed(static_cast<int>(power_up & 0x7fffffffU) | 1);
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

  VerilatedContext& context() { return *context_; }
  Top& top() { return *top_; }

  bool first_use = true;  ///< for SpareInstances

 private:
  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Top> top_;
};

/// Verilator counts coverage in each instance of a class. When coverage is measured, instances are
/// kept and used again, and write their counts when the process ends.
template <class Top>
class SpareInstances {
 public:
  static SpareInstances& instance() {
    static SpareInstances all;
    return all;
  }
  std::unique_ptr<Instance<Top>> take() {
    const std::lock_guard lock(guard_);
    if (spare_.empty()) return {};
    auto machine = std::move(spare_.back());
    spare_.pop_back();
    return machine;
  }
  void give(std::unique_ptr<Instance<Top>> machine) {
    // A random power-up state toggles bits, but not by the stimuli: the first use does not count.
    if (std::exchange(machine->first_use, false)) machine->context().coveragep()->zero();
    const std::lock_guard lock(guard_);
    spare_.push_back(std::move(machine));
  }
  ~SpareInstances() {
    static std::atomic<int> number{0};
    for (const auto& machine : spare_) {
      const std::string path = coverage::file_for(machine->top().modelName(), number++);
      if (!path.empty()) machine->context().coveragep()->write(path.c_str());
    }
  }

 private:
  std::mutex guard_;
  std::vector<std::unique_ptr<Instance<Top>>> spare_;
};

/// A machine to use. When coverage is measured, its registers may hold values of an earlier use in
/// place of those from `power_up`.
template <class Top>
std::unique_ptr<Instance<Top>> acquire(std::uint32_t power_up) {
  if constexpr (coverage::measured) {
    if (auto spare = SpareInstances<Top>::instance().take()) return spare;
  }
  return std::make_unique<Instance<Top>>(power_up);
}

/// To be called when a machine is no longer used.
template <class Top>
void release(std::unique_ptr<Instance<Top>> machine) {
  if constexpr (coverage::measured) {
    SpareInstances<Top>::instance().give(std::move(machine));
  }
}

}  // namespace cosim
