// How a design is reset, as its struct Design says: reset_inputs(), the inputs that reset it, on
// reset_clocks clocks, at the edge or, where asynchronous_reset says so, at once; or no
// reset_inputs() at all, for a design that only begins at its initial values. Where there are
// several asynchronous resets, the model's function reset(p, s, in) is the state s under those that
// `in` gives.
#pragma once

#include <cstddef>

#include "model/core/design.h"

namespace cosim {

/// Whether inputs can reset the design. One that has no reset_inputs() begins in the state
/// reset_state().
template <class Design>
inline constexpr bool has_reset = requires {
  Design::reset_inputs();
};

/// The inputs that reset the design: reset_inputs(), while every clock takes its edge.
template <class Design>
constexpr auto reset_inputs_of() {
  auto reset = Design::reset_inputs();
  if constexpr (clocks_of<Design> != 0) decltype(reset)::Table::raise_clocks(reset);
  return reset;
}

/// How many clocks reset_inputs() is to be given: Design::reset_clocks, or 1.
template <class Design>
constexpr int reset_clocks_of() {
  if constexpr (requires { Design::reset_clocks; }) {
    static_assert(Design::reset_clocks >= (has_reset<Design> ? 1 : 0));
    return Design::reset_clocks;
  } else if constexpr (has_reset<Design>) {
    return 1;
  } else {
    return 0;
  }
}

/// Whether the model says itself what each asynchronous reset resets, with reset(p, s, in).
template <class Design>
inline constexpr bool has_reset_function =
    requires(const typename Design::Params& p, const typename Design::template State<Word>& s,
             const typename Design::template Inputs<Word>& in) {
  reset(p, s, in);
};

/// Whether the reset does not wait for the clock: the model has reset(p, s, in), or
/// Design::asynchronous_reset says so.
template <class Design>
constexpr bool is_reset_asynchronous() {
  if constexpr (has_reset_function<Design>) {
    static_assert(has_reset<Design>, "reset_inputs() gives all the resets");
    return true;
  } else if constexpr (requires { Design::asynchronous_reset; }) {
    static_assert(has_reset<Design> || !Design::asynchronous_reset,
                  "an asynchronous reset is what reset_inputs() gives");
    return Design::asynchronous_reset;
  } else {
    return false;
  }
}

/// Whether the inputs reset the design: all pins that reset_inputs() sets otherwise than rest()
/// does.
template <class Design, class V>
constexpr Condition<V> resets(const typename Design::template Inputs<V>& in) {
  const auto reset = to_words(reset_inputs_of<Design>()), rest = to_words(rest_of<Design>());
  Condition<V> all = V(0) == V(0);
  for_each_cell<typename Design::template Inputs<V>>([&](auto cell, std::size_t i) {
    if (reset[i] != rest[i]) all = all & (cell(in) == V(reset[i]));
  });
  return all;
}

/// The state s as a clock with these inputs sees it: under an asynchronous reset it is reset
/// already, but for what that does not reach.
template <class Design, class V>
constexpr decltype(auto) seen_state(const typename Design::Params& p,
                                    const typename Design::template State<V>& s,
                                    const typename Design::template Inputs<V>& in) {
  if constexpr (has_reset_function<Design>) {
    return reset(p, s, in);
  } else if constexpr (is_reset_asynchronous<Design>()) {
    using State = typename Design::template State<V>;
    const auto fields = Design::template State<Word>::fields(p);
    auto reset_state = reset_state_of<Design, V>(p);
    for_each_cell<State>([&](auto cell, std::size_t i) {
      if (fields[i].unreset) cell(reset_state) = cell(s);
    });
    return select_record(resets<Design, V>(in), reset_state, s);
  } else {
    return (s);
  }
}

/// One clock: next() of the state that it sees, and the same of what comes of it.
template <class Design, class V>
constexpr auto clock_of(const typename Design::Params& p,
                        const typename Design::template State<V>& s,
                        const typename Design::template Inputs<V>& in) {
  if constexpr (is_reset_asynchronous<Design>()) {
    auto step = Design::next(p, seen_state<Design, V>(p, s, in), in);
    step.state = seen_state<Design, V>(p, step.state, in);
    return step;
  } else {
    return Design::next(p, s, in);
  }
}

}  // namespace cosim
