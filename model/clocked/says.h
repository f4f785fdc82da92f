// What a model may say beside its clock. Each is a member, found by its name:
//
//   static constexpr auto reset = active_low<&In::rst_n>;      the pins that reset it, together;
//                                 active_high<&In::rst>, both(active_high<...>, active_low<...>);
//                                 none: it begins at its initial values
//   static constexpr int reset_clocks = 3;                     so many clocks of it are needed; 1
//   static constexpr bool asynchronous_reset = true;           it does not wait for the clock
//   void reset_at_once(const In&) what each of several asynchronous resets does to the registers
//   static constexpr In rest()    the inputs of a clock with nothing to do; else all 0. A reset pin
//                                 is inactive whatever stands here
//   auto cases(const In&) const   what must be possible on a clock
//   auto legal(const In&) const   what is assumed of the inputs
//   In idle() const               inputs that are legal in any state; else rest()
//   auto invariant() const        what holds of the registers on every clock, and is needed to
//                                 prove that RTL and model are the same
//   auto reached() const          what holds of them, and is proved, but is not needed
//   auto compared() const         registers that are compared on some clocks alone
//   auto compared(const In&, const Out&) const     the same of outputs
//   static constexpr std::array unobserved{"debug.*"};         what of the RTL is not compared
//   static constexpr const char* source = "SU 1631518";        the printed source of the design
//   static constexpr std::string_view register_suffix = "_q";  of each register's name in the RTL
//   using View = ...              what a person wants to see beside registers and ports: a class
//   with
//                                 probes(), clock(model, out) and values(), see model/core/probe.h
//
// What is plural gives stated({{"a byte is taken", left == 0 && in.valid}, ...}), sentences with
// their conditions; of compared() the sentence is the member's name.
//
// Jobs, where the design is given something to do as a whole:
//
//   struct Job { Range<0, 40> idle; Range<0, 255> byte; };     numbers, drawn from their ranges
//   struct Driver {               the device outside; its members are as initialized when a job
//                                 begins
//     In drive(const Job&, In rest) const              the inputs of the next clock
//     Bit driven(const Job&, const Out&)               after that clock; 1 where the job is over
//   };
//   struct Checker {              and what is to come of it, if that is checked
//     Bit checked(const Job&, const Driver&, const Out&, const Bit& over)
//                                 on each clock, the last where it is over; 1 where it is wrong
//   };
//   static constexpr std::uint64_t most_clocks = 1000;         a job that is longer waits for ever
//
// Work that is no list of numbers: Job is then what driver and checker see of it.
//
//   using Work = Arc;
//   static Job job_of(const Work&)
//   static Checker checker_of(const Work&)                     as its job begins; if it is checked
//   static std::vector<Work> smaller(const Work&)              to try where it fails, simplest
//   first static std::string describe(const Work&)                   in one line
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "model/clocked/fields.h"

namespace cosim::clocked {

/// A sentence on a model, and whether it holds.
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

/// Pins of In, and the value with which they reset.
template <bool LEVEL, auto... PINS>
struct Level {
  /// Sets them so that they reset, or so that they do not.
  template <class In>
  static constexpr void set(In& in, bool resets) {
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
  static constexpr void set(In& in, bool resets) {
    (Levels::set(in, resets), ...);
  }
};
/// Pins of either level.
template <class... Levels>
constexpr Together<Levels...> both(Levels...) {
  return {};
}

template <class M>
concept SaysReset = requires {
  M::reset;
};

/// The inputs of a clock at rest, or, where `resets`, of a reset.
template <class M>
constexpr typename M::In resting(bool resets) {
  auto in = [] {
    if constexpr (requires { M::rest(); }) {
      return M::rest();
    } else {
      return zero<typename M::In>();
    }
  }();
  if constexpr (SaysReset<M>) M::reset.set(in, resets);
  return in;
}

}  // namespace cosim::clocked
