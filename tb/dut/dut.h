// One DUT: an instance of the RTL, or what a test puts in its place. An adapter is a DUT of one
// shape: a class derived from Dut, with
//
//   params                       the shape's parameters, static constexpr
//   Adapter(uint32_t power_up)   registers hold random values that follow from power_up
//
// Lockstep of an adapter calls its functions directly, and is compiled for each shape; that of
// AnyAdapter calls them as virtual ones, and is compiled once for a design.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "model/core/fields.h"
#include "tb/dut/said.h"
#include "tb/show/signal.h"

namespace cosim {

template <class D>
class Dut {
 public:
  using Design = D;
  using Inputs = typename D::template Inputs<Word>;
  using Outputs = typename D::template Outputs<Word>;
  using Registers = typename D::template Registers<Word>;

  virtual ~Dut() = default;
  /// Sets the input pins.
  virtual void drive(const Inputs& in) = 0;
  /// Sets the clock pin and settles everything that depends on it.
  virtual void eval(bool clk) = 0;
  /// What they hold now.
  virtual Outputs outputs() const = 0;
  virtual Registers registers() const = 0;
  /// Sets a register before the first eval; of a DUT whose maker says that it can.
  virtual void load(const Field& /*field*/, Word /*value*/) {}
  /// Whether turn() does what it says; where not, synchronizers take the old value.
  virtual bool turns() const { return false; }
  /// Turns these bits of registers over, after an edge.
  virtual void turn(const Registers& /*bits*/) {}
  /// Every signal of the hierarchy; empty if the instance does not show them.
  virtual std::vector<Signal> signals() const { return {}; }
  /// What the RTL said of itself since it was made or began; null: nothing.
  virtual const RtlSaid* said() const { return nullptr; }
  /// The reset has ended: what the RTL said before does not count.
  virtual void begin() {}
};

/// How the DUTs of one shape are made.
template <class Design>
struct DutMaker {
  typename Design::Params params;
  bool can_load;  ///< registers can be set before the first eval
  std::function<std::unique_ptr<Dut<Design>>(std::uint32_t power_up)> make;
};

template <class Adapter>
DutMaker<typename Adapter::Design> dut_maker() {
  using Design = typename Adapter::Design;
  const auto make = [](std::uint32_t power_up) -> std::unique_ptr<Dut<Design>> {
    return std::make_unique<Adapter>(power_up);
  };
  return {Adapter::params, false, make};
}

/// A Dut as an adapter: what Lockstep takes.
template <class D>
class AnyAdapter {
 public:
  using Design = D;

  struct PowerUp {
    const DutMaker<D>& maker;
    std::uint32_t power_up;
  };
  explicit AnyAdapter(const PowerUp& p) : params(p.maker.params), dut_(p.maker.make(p.power_up)) {}

  const typename D::Params params;
  void drive(const typename D::template Inputs<Word>& in) { dut_->drive(in); }
  void eval(bool clk) { dut_->eval(clk); }
  typename D::template Outputs<Word> outputs() const { return dut_->outputs(); }
  typename D::template Registers<Word> registers() const { return dut_->registers(); }
  void load(const Field& field, Word value) { dut_->load(field, value); }
  bool turns() const { return dut_->turns(); }
  void turn(const typename D::template Registers<Word>& bits) { dut_->turn(bits); }
  std::vector<Signal> signals() const { return dut_->signals(); }
  const RtlSaid* said() const { return dut_->said(); }
  void begin() { dut_->begin(); }

 private:
  std::unique_ptr<Dut<D>> dut_;
};

}  // namespace cosim
