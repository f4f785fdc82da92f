// A design as one type, for code that is generic over designs: that of a struct, or of struct
// shapes, is clocked::DesignOf. What a model may leave out has its default here.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/core/fields.h"
#include "model/core/job.h"
#include "model/core/stated.h"
#include "model/core/value.h"

namespace cosim {

/// What one clock does: the outputs during it and the state after it.
template <class StateRecord, class OutputsRecord>
struct StepOf {
  StateRecord state;
  OutputsRecord outputs;
};

/// Whether the design has a clock on values of type V. A model of streams alone has none.
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

/// Inputs of a step on which the design has nothing to do: rest(); every clock takes its edge.
template <class Design>
constexpr auto rest_of() {
  auto rest = Design::rest();
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

/// The state after a reset.
template <class Design, class V>
constexpr auto reset_state_of(const typename Design::Params& p) {
  return Design::template reset_state<V>(p);
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
