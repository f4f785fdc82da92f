// Lockstep: one RTL instance and its golden model get the same inputs on every clock, and every
// register and output is compared on every clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "model/core/fields.h"
#include "tb/coverage/counts.h"

namespace cosim {

/// Everything compared on one clock. Registers stand first: a wrong register shows before the
/// outputs it spoils.
template <class Design>
struct Compared {
  typename Design::template Registers<Word> registers;
  typename Design::template Outputs<Word> outputs;

  /// True where any bit of any field differs.
  friend bool differ(const Compared& a, const Compared& b) {
    Word bits = 0;
    const auto gather = [&bits](const auto& left, const auto& right) {
      for_each_member<std::decay_t<decltype(left)>>(
          [&](auto member, std::size_t) { bits |= left.*member ^ right.*member; });
    };
    gather(a.registers, b.registers);
    gather(a.outputs, b.outputs);
    return bits != 0;
  }
};

template <class Adapter>
class Lockstep {
 public:
  using Design = typename Adapter::Design;
  using Inputs = typename Design::template Inputs<Word>;
  using State = typename Design::template State<Word>;

  /// Powers up at random from `power_up`, then clears both sides: one clock, not compared, for
  /// before it the RTL's registers hold anything.
  explicit Lockstep(std::uint32_t power_up)
      : dut_(power_up), state_(Design::template cleared<Word>()) {
    dut_.drive(Design::clear());
    edge();
  }
  /// Starts both sides from `state` instead, for an adapter that can load registers.
  Lockstep(std::uint32_t power_up, const State& state) : dut_(power_up), state_(state) {
    const auto fields = Design::template Registers<Word>::fields(Adapter::params);
    const auto words = to_words(Design::registers(Adapter::params, state));
    for (std::size_t i = 0; i < fields.size(); ++i) dut_.load(fields[i].name, words[i]);
  }

  /// One clock: drives, settles, compares, then the rising edge. False where anything differs; the
  /// clock is completed all the same, so that the clocks behind a difference can be shown.
  /// `sample(expected, actual)` is called before the edge.
  /// Flattened, so that the model sees its parameters as constants.
  template <class Sample>
  [[gnu::flatten]] bool clock(const Inputs& in, Sample&& sample) {
    const auto step = Design::next(Adapter::params, state_, in);
    coverage::count<Adapter>(state_, in, step);
    expected_ = {Design::registers(Adapter::params, state_), step.outputs};
    dut_.drive(in);
    dut_.eval(false);
    const Compared<Design> actual = {dut_.registers(), dut_.outputs()};
    sample(std::as_const(expected_), actual);
    dut_.eval(true);
    state_ = step.state;
    if (!differ(expected_, actual)) [[likely]]
      return true;
    actual_ = actual;
    return false;
  }
  bool clock(const Inputs& in) {
    return clock(in, [](const auto&, const auto&) {});
  }

  /// The model's state before the next clock.
  const State& state() const { return state_; }
  const Adapter& dut() const { return dut_; }
  /// What the model gave on the last clock.
  const Compared<Design>& expected() const { return expected_; }
  /// What the RTL gave on the last clock that differed.
  const Compared<Design>& actual() const { return actual_; }

 private:
  void edge() {
    dut_.eval(false);
    dut_.eval(true);
  }

  Adapter dut_;
  State state_;
  Compared<Design> expected_{};
  Compared<Design> actual_{};
};

}  // namespace cosim
