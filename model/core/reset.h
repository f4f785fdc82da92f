// How a design is reset, as its struct Design says: clear(), the inputs that clear it, on
// clear_clocks clocks, at the edge or, where asynchronous_reset says so, at once; or no clear() at
// all, for a design that only begins at its initial values. Where there are several asynchronous
// resets, the model's function reset(p, s, in) is the state s under those that `in` gives.
#pragma once

#include <cstddef>

#include "model/core/design.h"

namespace cosim {

/// Whether inputs can clear the design. One that has no clear() begins in the state cleared().
template <class Design>
inline constexpr bool has_clear = requires {
  Design::clear();
};

/// The inputs that clear the design: clear(), while every clock takes its edge.
template <class Design>
constexpr auto clear_of() {
  auto clear = Design::clear();
  if constexpr (clocks_of<Design> != 0) decltype(clear)::Table::raise_clocks(clear);
  return clear;
}

/// How many clocks clear() is to be given: Design::clear_clocks, or 1.
template <class Design>
constexpr int clear_clocks_of() {
  if constexpr (requires { Design::clear_clocks; }) {
    static_assert(Design::clear_clocks >= 1);
    return Design::clear_clocks;
  } else if constexpr (has_clear<Design>) {
    return 1;
  } else {
    return 0;
  }
}

/// Whether the model says itself what each asynchronous reset clears, with reset(p, s, in).
template <class Design>
inline constexpr bool has_reset = requires(const typename Design::Params& p,
                                           const typename Design::template State<Word>& s,
                                           const typename Design::template Inputs<Word>& in) {
  reset(p, s, in);
};

/// Whether the reset does not wait for the clock: the model has reset(p, s, in), or
/// Design::asynchronous_reset says so.
template <class Design>
constexpr bool is_reset_asynchronous() {
  if constexpr (has_reset<Design>) {
    static_assert(has_clear<Design>, "clear() gives all the resets");
    return true;
  } else if constexpr (requires { Design::asynchronous_reset; }) {
    static_assert(has_clear<Design>, "an asynchronous reset is what clear() gives");
    return Design::asynchronous_reset;
  } else {
    return false;
  }
}

/// Whether the inputs reset the design: all pins that clear() sets otherwise than rest() does.
template <class Design, class V>
constexpr Condition<V> resets(const typename Design::template Inputs<V>& in) {
  const auto clear = to_words(clear_of<Design>()), rest = to_words(rest_of<Design>());
  Condition<V> all = V(0) == V(0);
  for_each_cell<typename Design::template Inputs<V>>([&](auto cell, std::size_t i) {
    if (clear[i] != rest[i]) all = all & (cell(in) == V(clear[i]));
  });
  return all;
}

/// The state s as a clock with these inputs sees it: under an asynchronous reset it is cleared
/// already, but for what that does not reach.
template <class Design, class V>
constexpr decltype(auto) seen_state(const typename Design::Params& p,
                                    const typename Design::template State<V>& s,
                                    const typename Design::template Inputs<V>& in) {
  if constexpr (has_reset<Design>) {
    return reset(p, s, in);
  } else if constexpr (is_reset_asynchronous<Design>()) {
    using State = typename Design::template State<V>;
    const auto fields = Design::template State<Word>::fields(p);
    auto cleared = cleared_of<Design, V>();
    for_each_cell<State>([&](auto cell, std::size_t i) {
      if (fields[i].unreset) cell(cleared) = cell(s);
    });
    return select_record(resets<Design, V>(in), cleared, s);
  } else {
    return (s);
  }
}

/// One clock: next() of the state that it sees, and the same of what comes of it.
template <class Design, class V>
constexpr auto clocked(const typename Design::Params& p,
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
