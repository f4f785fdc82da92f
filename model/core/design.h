// A design as one type, for code that is generic over designs: struct Design of its model. What a
// design may leave out has its default here.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/core/bit_strings.h"
#include "model/core/job.h"
#include "model/core/memory.h"
#include "model/core/record.h"
#include "model/core/stated.h"
#include "model/core/value.h"

namespace cosim {

/// What one clock does: the outputs during it and the state after it.
template <class StateRecord, class OutputsRecord>
struct StepOf {
  StateRecord state;
  OutputsRecord outputs;
};

namespace detail {

/// What the RTL's registers hold in state s: registers(p, s). Where a model has no such function:
/// the fields of s, with signed numbers as their codes.
template <class Params, class State>
constexpr auto registers_of(const Params& p, const State& s) {
  if constexpr (requires { registers(p, s); }) {
    return registers(p, s);
  } else {
    State codes = s;
    const auto fields = State::fields(p);
    for_each_member<State>([&](auto member, std::size_t i) {
      const Field& f = fields[i];
      if (f.format == Format::twos_complement) {
        for_each_value(codes.*member, [&](auto& value) { value = low_bits(value, f.width); });
      }
      if (f.format == Format::ones_complement) {
        for_each_value(codes.*member,
                       [&](auto& value) { value = to_ones_complement(value, f.width); });
      }
    });
    return codes;
  }
}

}  // namespace detail

/// Whether the design's next() takes values of type V. That of a generic model takes any V; that of
/// a plain model, a function of State<Word> and Inputs<Word>, takes machine integers only.
template <class Design, class V>
concept StepsOn = requires(const typename Design::Params& p,
                           const typename Design::template State<V>& s,
                           const typename Design::template Inputs<V>& in) {
  Design::next(p, s, in);
};

/// How many of the inputs are clocks: 0 where the design has one, which is no input, or none.
template <class Design>
inline constexpr int clocks_of = 0;
template <class Design>
requires requires { typename Design::template Inputs<Word>; }
inline constexpr int clocks_of<Design> = Design::template Inputs<Word>::Table::clocks;

/// Inputs of a step on which the design has nothing to do: rest(), or all 0; every clock takes its
/// edge.
template <class Design>
constexpr auto rest_of() {
  typename Design::template Inputs<Word> rest{};
  if constexpr (requires { Design::rest(); }) rest = Design::rest();
  if constexpr (clocks_of<Design> != 0) decltype(rest)::Table::raise_clocks(rest);
  return rest;
}

/// The same as values of type V.
template <class Design, class V>
constexpr auto rest_on() {
  if constexpr (std::same_as<V, Word>) {
    return rest_of<Design>();
  } else {
    typename Design::template Inputs<V> in;
    const auto words = to_words(rest_of<Design>());
    for_each_cell<typename Design::template Inputs<V>>(
        [&](auto cell, std::size_t i) { cell(in) = V(words[i]); });
    return in;
  }
}

/// Whether its state after a reset depends on the shape.
template <class Design, class V>
concept ResetsByShape = requires(const typename Design::Params& p) {
  Design::template reset_state<V>(p);
};
/// The state after a reset: reset_state<V>(), or all 0.
template <class Design, class V>
constexpr auto reset_state_of([[maybe_unused]] const typename Design::Params& p) {
  using State = typename Design::template State<V>;
  if constexpr (ResetsByShape<Design, V>) {
    return Design::template reset_state<V>(p);
  } else if constexpr (requires { Design::template reset_state<V>(); }) {
    return Design::template reset_state<V>();
  } else {
    State s;
    for_each_cell<State>([&](auto cell, std::size_t) { cell(s) = V(0); });
    return s;
  }
}

/// The parameters by the RTL's names: parameters(p), or none.
template <class Design>
constexpr auto parameters_of(const typename Design::Params& p) {
  if constexpr (requires { Design::parameters(p); }) {
    return Design::parameters(p);
  } else {
    return std::array<Parameter, 0>{};
  }
}

/// Registers and outputs of the RTL that no table names and that are not compared:
/// Design::unobserved, an array of paths and patterns such as "debug.*"; none by default.
template <class Design>
constexpr auto unobserved_of() {
  if constexpr (requires { Design::unobserved; }) {
    return Design::unobserved;
  } else {
    return std::array<const char*, 0>{};
  }
}

/// The printed source of the design, or "".
template <class Design>
constexpr const char* source_of() {
  if constexpr (requires { Design::source; }) {
    return Design::source;
  } else {
    return "";
  }
}

// What a model may state beside its step: each is a function of that name, found by its arguments.
// Of one that it does not have: nothing.
#define COSIM_STATED(NAME, FUNCTION)                                                   \
  template <class V, class Params, class State, class... More>                         \
  constexpr auto NAME(const Params& params, const State& state, const More&... more) { \
    if constexpr (requires { FUNCTION(params, state, more...); }) {                    \
      return FUNCTION(params, state, more...);                                         \
    } else {                                                                           \
      return std::array<Stated<V>, 0>{};                                               \
    }                                                                                  \
  }                                                                                    \
  static_assert(true, "so that a semicolon stands behind it")
COSIM_STATED(invariant_of, invariant);  // (p, s)
COSIM_STATED(reached_of, reached);      // (p, s)
COSIM_STATED(cases_of, cases);          // (p, s, in)
COSIM_STATED(legal_of, legal);          // (p, s, in)
/// Registers that mean something in some states only: compared(p, s), the name of each with the
/// condition.
COSIM_STATED(registers_compared_of, compared);
/// The same of outputs, on some clocks only: compared(p, s, in, out), of the state before the
/// clock, its inputs and the model's outputs.
COSIM_STATED(outputs_compared_of, compared);
#undef COSIM_STATED
template <class Design>
inline constexpr bool compares_some_registers =
    requires(const typename Design::Params& p, const typename Design::template State<Word>& s) {
  compared(p, s);
};
template <class Design>
inline constexpr bool compares_some_outputs =
    requires(const typename Design::Params& p, const typename Design::template State<Word>& s,
             const typename Design::template Inputs<Word>& in,
             const typename Design::template Outputs<Word>& out) {
  compared(p, s, in, out);
};

/// Whether a design states which inputs are legal in a state, with legal(p, s, in).
template <class Design>
inline constexpr bool has_legal = requires(const typename Design::Params& p,
                                           const typename Design::template State<Word>& s,
                                           const typename Design::template Inputs<Word>& in) {
  legal(p, s, in);
};

/// Legal inputs for a clock in state s on which the design has as little to do as possible: idle(p,
/// s). Where a model has no such function: rest_of<Design>(), which must then always be legal.
template <class Design, class V>
constexpr auto idle_of(const typename Design::Params& p,
                       const typename Design::template State<V>& s) {
  if constexpr (requires { idle(p, s); }) {
    return idle(p, s);
  } else {
    return rest_on<Design, V>();
  }
}

/// The host of a design without one: there are no jobs, any pin may have any value on any clock.
template <class Design>
class NoHost {
 public:
  struct Job {};
  NoHost(const typename Design::Params&, std::span<const Job>) {}
  bool next(typename Design::template Inputs<Word>&,
            const typename Design::template Outputs<Word>&) {
    return false;
  }
  static std::vector<Job> smaller(const typename Design::Params&, const Job&) { return {}; }
  static std::string describe(const typename Design::Params&, const Job&) { return {}; }
  std::size_t job() const { return 0; }
};

namespace detail {

template <class Design>
struct HostTypes {
  using Host = NoHost<Design>;
};
template <HasJobs Design>
struct HostTypes<Design> {
  using Host = JobHost<Design>;
};

}  // namespace detail

/// What drives the design's jobs (job.h), or a host without jobs.
template <class Design>
using HostOf = typename detail::HostTypes<Design>::Host;

}  // namespace cosim

/// Defines the records Inputs, Outputs and State from the tables PREFIX_INPUTS, PREFIX_OUTPUTS and
/// PREFIX_STATE, and Step, what next() gives.
#define COSIM_RECORDS(PREFIX, Params)              \
  COSIM_RECORD(Inputs, PREFIX##_INPUTS, Params);   \
  COSIM_RECORD(Outputs, PREFIX##_OUTPUTS, Params); \
  COSIM_RECORD(State, PREFIX##_STATE, Params);     \
  template <class V>                               \
  using Step = ::cosim::StepOf<State<V>, Outputs<V>>

/// What struct Design takes over from its own namespace: the types of the same names, next(), and
/// registers() where there is one.
#define COSIM_DESIGN(space)                                                                      \
  using Params = space::Params;                                                                  \
  template <class V>                                                                             \
  using Inputs = space::Inputs<V>;                                                               \
  template <class V>                                                                             \
  using Outputs = space::Outputs<V>;                                                             \
  template <class V>                                                                             \
  using State = space::State<V>;                                                                 \
  template <class V>                                                                             \
  static constexpr auto next(const Params& p, const State<V>& s,                                 \
                             const Inputs<V>& in) requires requires {                            \
    space::next(p, s, in);                                                                       \
  }                                                                                              \
  { return space::next(p, s, in); }                                                              \
  template <class V>                                                                             \
  static constexpr auto registers(const Params& p, const State<V>& s) {                          \
    return ::cosim::detail::registers_of(p, s);                                                  \
  }                                                                                              \
  template <class V>                                                                             \
  using Registers =                                                                              \
      decltype(::cosim::detail::registers_of(std::declval<Params>(), std::declval<State<V>>())); \
  static_assert(true, "so that a semicolon stands behind it")

/// The same of jobs that no table declares (job.h), and of what a person wants to see of it: the
/// types Job, Task, Driver, Checker and View, which the namespace only has to declare.
#define COSIM_DESIGN_JOBS(space)     \
  using Job = space::Job;            \
  template <class V>                 \
  using Task = space::Task<V>;       \
  template <class V>                 \
  using Driver = space::Driver<V>;   \
  template <class V>                 \
  using Checker = space::Checker<V>; \
  using View = space::View;          \
  static_assert(true, "so that a semicolon stands behind it")
/// Declares the last four.
#define COSIM_JOB_TYPES \
  template <class V>    \
  struct Task;          \
  template <class V>    \
  struct Driver;        \
  template <class V>    \
  struct Checker;       \
  class View
