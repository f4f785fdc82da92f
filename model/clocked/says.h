// What a model may have beside its clock(). Each is a member, found by its name:
//
//   static constexpr auto reset = active_low<&In::rst_n>;      the pins that reset it, together;
//                                 active_high<&In::rst>, both(active_high<...>, active_low<...>);
//                                 without it the design begins at its initial values
//   static constexpr int reset_clocks = 3;                     clocks that a reset lasts; default 1
//   static constexpr bool asynchronous_reset = true;           a reset does not wait for the edge
//   void reset_at_once(const In&) what each of several asynchronous resets does to the registers
//   static constexpr In rest()    the inputs of an idle clock; default all 0. Reset pins are made
//                                 inactive whatever it returns
//   auto cases(const In&) const   what must be possible on a clock
//   auto legal(const In&) const   assumptions about the inputs
//   In idle() const               inputs that are legal in any state; default rest()
//   auto invariant() const        holds for the registers on every clock, and is needed to prove
//                                 that RTL and model are the same
//   auto reached() const          holds for them and is proved, but is not needed
//   auto compared() const         registers that are compared only on some clocks
//   auto compared(const In&, const Out&) const     the same for outputs
//   static constexpr std::array unobserved{"debug.*"};         RTL registers that are not compared
//   static constexpr const char* source = "SU 1631518";        the printed source of the design
//   static constexpr std::string_view register_suffix = "_q";  ends each register's name in the RTL
//   using View = ...              what a wave shows beside registers and ports: a class with
//                                 probes(), clock(model, out) and values(), see model/core/probe.h
//
// cases, legal, invariant, reached and compared return stated({{"a byte is taken", left == 0 &&
// in.valid}, ...}), sentences with their conditions; for compared() the sentence is the name of the
// member.
//
// Jobs, for a design that is given something to do as a whole:
//
//   struct Job { Range<0, 40> idle; Range<0, 255> byte; };     numbers, drawn from their ranges
//   struct Driver {               the environment; its members are as initialized when a job begins
//     In drive(const Job&, In rest) const              the inputs of the next clock
//     Bit driven(const Job&, const Out&)               after that clock; 1 if the job is over
//   };
//   struct Checker {              optional: checks what the design does
//     Bit checked(const Job&, const Driver&, const Out&, const Bit& over)
//                                 on each clock; `over` is 1 on the last one. 1 if it is wrong
//   };
//   static constexpr std::uint64_t most_clocks = 1000;         a longer job waits for ever
//
// Work that is not a list of numbers has a type of its own. Job is then the part of it that driver
// and checker use.
//
//   using Work = Arc;
//   static Job job_of(const Work&)
//   static Checker checker_of(const Work&)                     its checker, as the job begins
//   static std::vector<Work> smaller(const Work&)              smaller work, the simplest first
//   static std::string describe(const Work&)                   its text in reports, one line
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <utility>

#include "model/clocked/fields.h"

namespace cosim::clocked {

/// A sentence about a model, and whether it holds: 1 if it does.
struct Stated {
  const char* sentence;
  Bit holds;
};
template <std::size_t N>
constexpr std::array<Stated, N> stated(const Stated (&all)[N]) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Stated, N>{all[I]...};
  }
  (std::make_index_sequence<N>());
}

/// Pins of In, and the level at which they reset: LEVEL, 1 or 0.
template <bool LEVEL, auto... PINS>
struct Level {
  /// Sets the pins to the level that resets, or to the other one.
  template <class In>
  requires(std::same_as<Base<std::remove_reference_t<decltype(std::declval<In&>().*PINS)>>,
                        Bit>&&...) static constexpr void set(In& in, bool resets) {
    ((in.*PINS = resets == LEVEL), ...);
  }
};
template <auto... PINS>
inline constexpr Level<true, PINS...> active_high{};
template <auto... PINS>
inline constexpr Level<false, PINS...> active_low{};

template <class... Levels>
struct Together {
  template <class In>
  requires(requires(In& in) { Levels::set(in, true); } &&
           ...) static constexpr void set(In& in, bool resets) {
    (Levels::set(in, resets), ...);
  }
};
/// Reset pins of both levels: both(active_high<&In::a>, active_low<&In::b>).
template <class... Levels>
constexpr Together<Levels...> both(Levels...) {
  return {};
}

template <class M>
concept SaysReset = requires {
  M::reset;
};

template <class M>
concept HasClock = requires(M m, const typename M::In& in) {
  { m.clock(in) } -> std::same_as<typename M::Out>;
};

/// Stops the compiler where a model has no clock().
template <class M>
consteval void check_clock() {
  static_assert(
      HasClock<M>,
      "a model has a function Out clock(const In& in), which is const if it has no registers");
}

/// The inputs of an idle clock: rest(), or all 0. The reset pins are active if `resets`.
template <class M>
constexpr typename M::In resting(bool resets) {
  auto in = [] {
    if constexpr (requires { M::rest(); }) {
      return M::rest();
    } else {
      return zero<typename M::In>();
    }
  }();
  if constexpr (SaysReset<M>) {
    static_assert(
        requires { M::reset.set(in, resets); },
        "reset is active_low<&In::rst_n>, active_high<&In::rst> or both(...) of pins that are a "
        "Bit");
    M::reset.set(in, resets);
  }
  return in;
}

}  // namespace cosim::clocked
