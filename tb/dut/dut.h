// One DUT: an instance of the RTL, or what a test puts in its place. The adapter is the fast form,
// one class for each shape. Dut is the same with virtual calls, for code compiled once for a
// design.
//
// An adapter has the types and members
//
//   Design                       struct Design of model/NAME/machine.h
//   params                       the shape's parameters, static constexpr
//   Adapter(uint32_t power_up)   registers hold random values that follow from power_up
//   drive(inputs)                sets the input pins
//   eval(bool clk)               sets the clock pin and settles everything that depends on it
//   outputs(), registers()       what they hold now
//   load(field, word)            may be absent: sets a register before the first eval
//   signals()                    may be absent: every signal of the hierarchy
//   said()                       may be absent: what the RTL says of itself
//   begin()                      may be absent: the reset has ended, and what was before it does
//                                not count
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "model/core/fields.h"
#include "tb/dut/said.h"
#include "tb/dut/signal.h"

namespace cosim {

template <class Design>
class Dut {
 public:
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using Registers = typename Design::template Registers<Word>;

  virtual ~Dut() = default;
  virtual void drive(const Inputs& in) = 0;
  virtual void eval(bool clk) = 0;
  virtual Outputs outputs() const = 0;
  virtual Registers registers() const = 0;
  /// std::logic_error if the maker says that registers cannot be loaded.
  virtual void load(const Field& field, Word value) = 0;
  /// Empty if the instance does not show them.
  virtual std::vector<Signal> signals() const { return {}; }
  /// What the RTL said of itself since it was made or began; null: nothing.
  virtual const RtlSaid* said() const { return nullptr; }
  /// The reset has ended: what the RTL said before does not count.
  virtual void begin() {}
};

/// An adapter as a Dut.
template <class Adapter>
class AdapterDut final : public Dut<typename Adapter::Design> {
  using Base = Dut<typename Adapter::Design>;

 public:
  static constexpr bool can_load = requires(Adapter & a) { a.load(Field{}, Word{}); };

  explicit AdapterDut(std::uint32_t power_up) : adapter_(power_up) {}
  void drive(const typename Base::Inputs& in) override { adapter_.drive(in); }
  void eval(bool clk) override { adapter_.eval(clk); }
  typename Base::Outputs outputs() const override { return adapter_.outputs(); }
  typename Base::Registers registers() const override { return adapter_.registers(); }
  void load([[maybe_unused]] const Field& field, [[maybe_unused]] Word value) override {
    if constexpr (can_load) {
      adapter_.load(field, value);
    } else {
      throw std::logic_error("registers of this DUT cannot be loaded");
    }
  }
  std::vector<Signal> signals() const override {
    if constexpr (requires { adapter_.signals(); }) return adapter_.signals();
    return {};
  }
  const RtlSaid* said() const override {
    if constexpr (requires { adapter_.said(); }) return adapter_.said();
    return nullptr;
  }
  void begin() override {
    if constexpr (requires { adapter_.begin(); }) adapter_.begin();
  }

 private:
  Adapter adapter_;
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
    return std::make_unique<AdapterDut<Adapter>>(power_up);
  };
  return {Adapter::params, AdapterDut<Adapter>::can_load, make};
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
  std::vector<Signal> signals() const { return dut_->signals(); }
  const RtlSaid* said() const { return dut_->said(); }
  void begin() { dut_->begin(); }

 private:
  std::unique_ptr<Dut<D>> dut_;
};

}  // namespace cosim
