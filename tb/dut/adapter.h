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

#include "model/core/value.h"
#include "tb/dut/instance.h"
#include "tb/dut/signal.h"

namespace cosim {

/// The signals of the instance in `context`.
std::vector<Signal> signals_of(VerilatedContext& context);
/// Sets name_q wherever it stands in the hierarchy: the register and the wires it goes through.
/// std::logic_error where it stands nowhere.
void load_register(VerilatedContext& context, const std::string& name, Word value);

/// Owns one instance of a Verilated class. Its registers power up at random from `power_up`, so
/// that a register no reset reaches is seen.
template <class Top>
class VerilatedInstance {
 public:
  explicit VerilatedInstance(std::uint32_t power_up) : machine_(acquire<Top>(power_up)) {}
  ~VerilatedInstance() { release(std::move(machine_)); }
  VerilatedInstance(const VerilatedInstance&) = delete;
  VerilatedInstance& operator=(const VerilatedInstance&) = delete;

  /// Brings the clock pin to a level and settles everything behind it.
  void eval(bool clk) {
    top_->clk = clk;
    top_->eval();
  }

  /// Every signal of the hierarchy. None but in a class Verilated with --vpi --public-flat-rw.
  std::vector<Signal> signals() const { return signals_of(machine_->context()); }
#ifndef COSIM_NETLIST  // there a register is a wire from flip-flops that are cells
  /// Sets the register that the field `name` stands for, before the first eval; in such a class.
  void load(const char* name, Word value) { load_register(machine_->context(), name, value); }
#endif

 protected:
  template <class Pin>
  static void set(Pin& pin, Word value) {
    pin = static_cast<Pin>(value);
  }
  template <class Pin>
  static Word get(const Pin& pin) {
    return static_cast<Word>(pin);
  }

  Top& top() { return *top_; }
  const Top& top() const { return *top_; }

 private:
  std::unique_ptr<Instance<Top>> machine_;
  Top* top_ = &machine_->top();
};

}  // namespace cosim
