// Lockstep: one RTL instance and its golden model get the same inputs on every clock, and every
// register and output is compared on every clock, but for what the design says means nothing then.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>

#include "model/core/design.h"
#include "model/core/fields.h"
#include "model/core/reset.h"
#include "model/core/synchronizer.h"
#include "tb/dut/counts.h"
#include "tb/dut/dut.h"
#include "tb/sim/compare_mask.h"

/// Inlines all calls in a function, and compiles it for speed in a file that is not. Not under the
/// sanitizers, where the compiler would take minutes.
#ifdef __SANITIZE_ADDRESS__
#define COSIM_FLATTEN
#elif defined(__clang__)  // files with such functions are compiled for speed
#define COSIM_FLATTEN [[gnu::flatten]]
#else
#define COSIM_FLATTEN [[gnu::flatten, gnu::optimize("O3")]]
#endif

namespace cosim {

/// Everything compared on one clock. Registers stand first: a wrong register shows before the
/// outputs it spoils.
template <class Design>
struct Compared {
  typename Design::template Registers<Word> registers;
  typename Design::template Outputs<Word> outputs;
};

/// Not 0 where any bit of any field differs.
template <class Record>
constexpr Word difference(const Record& a, const Record& b) {
  Word bits = 0;
  for_each_cell<Record>([&](auto cell, std::size_t) { bits |= cell(a) ^ cell(b); });
  return bits;
}

/// The same of the fields that are compared; the record's first is number `first` in `mask`.
template <class Record, class Design>
constexpr Word difference(const Record& a, const Record& b, const CompareMask<Design>& mask,
                          std::size_t first) {
  Word bits = 0;
  for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (mask[first + i]) bits |= cell(a) ^ cell(b);
  });
  return bits;
}

/// Copies field by field: a wider load would stall, because the fields have just been stored one by
/// one.
template <class Record>
constexpr void copy_fields(Record& to, const Record& from) {
  for_each_member<Record>([&](auto member, std::size_t) { to.*member = from.*member; });
}

/// `Adapter`: dut.h.
template <class Adapter>
class Lockstep {
 public:
  using Design = typename Adapter::Design;
  using Inputs = typename Design::template Inputs<Word>;
  using State = typename Design::template State<Word>;

  /// Makes the adapter, which powers up at random from `power_up`, and clears both sides. The
  /// clocks of that are not compared: before them the RTL's registers may hold any value. A design
  /// without a reset begins at its initial values.
  template <class PowerUp>
  explicit Lockstep(const PowerUp& power_up)
      : dut_(power_up), state_(reset_state_of<Design, Word>(dut_.params)), mask_(dut_.params) {
    if constexpr (has_reset<Design>) {
      dut_.drive(reset_inputs_of<Design>());
      for (int i = 0; i < reset_clocks_of<Design>(); ++i) edge();
    } else {
      dut_.drive(rest_of<Design>());
    }
    take_over();
    // Before that its registers held anything.
    dut_.begin();
  }
  /// Starts both sides from `state` instead, for an adapter that can load registers.
  template <class PowerUp>
  Lockstep(const PowerUp& power_up, const State& state)
      : dut_(power_up), state_(state), mask_(dut_.params) {
    dut_.drive(rest_of<Design>());
    const auto fields = Design::template Registers<Word>::fields(dut_.params);
    const auto words = to_words(Design::registers(dut_.params, state));
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].width != 0) dut_.load(fields[i], words[i]);
    }
  }

  /// One clock: drives, settles, compares, then the rising edge. False where anything differs, or
  /// where the RTL says that something is wrong; the clock is completed all the same, so that the
  /// clocks after a difference can be shown.
  bool clock(const Inputs& in) {
    return clocked_with(in, [](const Lockstep&) {});
  }
  /// Sees what both gave, before the edge.
  using Sample =
      std::function<void(const Compared<Design>& expected, const Compared<Design>& actual)>;
  bool clock(const Inputs& in, const Sample& sample) {
    return clocked_with(in, [&](const Lockstep& both) {
      sample(both.expected_, {both.dut_.registers(), both.dut_.outputs()});
    });
  }

  /// The model's state before the next clock.
  const State& state() const { return state_; }
  const Adapter& dut() const { return dut_; }
  /// What the model gave on the last clock.
  const Compared<Design>& expected() const { return expected_; }
  /// What of it was compared on the last clock.
  const CompareMask<Design>& mask() const { return mask_; }

 private:
  template <class Look>
  bool clocked_with(const Inputs& in, Look look) {
    dut_.drive(in);
    dut_.eval(false);
    const auto& seen = seen_state<Design, Word>(dut_.params, state_, in);
    copy_fields(expected_.registers, Design::registers(dut_.params, seen));
    Word bits = 0;
    if constexpr (!CompareMask<Design>::any)
      bits = difference(expected_.registers, dut_.registers());
    // One word from here on: else each register's difference waits on the stack for the outputs'.
    asm("" : "+r"(bits));
    const auto step = clock_of<Design, Word>(dut_.params, state_, in);
    coverage::count<Design>(dut_.params, seen, in);
    copy_fields(expected_.outputs, step.outputs);
    if constexpr (CompareMask<Design>::any) {
      mask_.clock(dut_.params, seen, in, step.outputs);
      bits = difference(expected_.registers, dut_.registers(), mask_, 0) |
             difference(expected_.outputs, dut_.outputs(), mask_, expected_.registers.size);
    } else {
      bits |= difference(expected_.outputs, dut_.outputs());
    }
    look(*this);
    if constexpr (Taking::any) {
      take(in, step.state);
    } else {
      copy_fields(state_, step.state);
      dut_.eval(true);
    }
    bits |= dut_.said() != nullptr ? 1 : 0;
    return bits == 0;
  }

  using Taking = Synchronizers<Design>;

  /// The rising edge, where synchronizers that take the old value make the model's state `old`.
  void take(const Inputs& in, const State& old) {
    const auto& p = dut_.params;
    const State taken = dut_.turns() ? taking_.taken(p, state_, in, old) : old;
    dut_.eval(true);
    auto bits = Design::registers(p, old);
    const auto held = Design::registers(p, taken);
    for_each_cell<decltype(bits)>([&](auto cell, std::size_t) { cell(bits) ^= cell(held); });
    dut_.turn(bits);
    copy_fields(state_, taken);
  }
  /// Gives the model what the RTL holds where no reset reaches. Such a register is a field of the
  /// state by the same name.
  void take_over() {
    using Registers = typename Design::template Registers<Word>;
    dut_.eval(false);
    const auto fields = Registers::fields(dut_.params);
    const auto of_state = State::fields(dut_.params);
    const auto held = to_words(Registers(dut_.registers()));
    auto words = to_words(state_);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (!fields[i].unreset || fields[i].width == 0) continue;
      const auto is_same = [&](const Field& f) {
        return f.index == fields[i].index && std::string_view(f.name) == fields[i].name;
      };
      // Where the registers are the state, the one at the same place.
      auto own = of_state.begin() + static_cast<std::ptrdiff_t>(std::min(i, of_state.size() - 1));
      if (!is_same(*own)) own = std::ranges::find_if(of_state, is_same);
      if (own == of_state.end()) continue;
      words[static_cast<std::size_t>(own - of_state.begin())] = units_of(fields[i], held[i]);
    }
    state_ = from_words<State>(words);
  }
  void edge() {
    dut_.eval(false);
    dut_.eval(true);
  }

  Adapter dut_;
  State state_;
  CompareMask<Design> mask_;
  Taking taking_{dut_.params};
  Compared<Design> expected_{};
};

}  // namespace cosim
