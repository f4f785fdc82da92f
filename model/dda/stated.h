// What is true of the DDA's state at all times, and what may happen on a clock of it.
#pragma once

#include <array>

#include "model/core/stated.h"
#include "model/dda/machine.h"

namespace cosim::dda {

/// Nothing: RTL and model stay equal from every state that registers() can encode.
template <class V>
constexpr std::array<Stated<V>, 0> invariant(const Params&, const State<V>&) {
  return {};
}

/// The clocks as a proof takes them one by one, each without those before it: here at once.
template <class V>
constexpr std::array<Stated<V>, 0> parts(const Params&, const State<V>&) {
  return {};
}

/// Each must be possible.
template <class V>
constexpr auto cases(const Params& p, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag reset = is_set(in.rst);
  const Flag no_reset = in.rst == V(0);
  const Flag stop = is_set(in.stop);
  const Flag quiet = !(reset | stop);
  const Flag running = quiet & is_set(s.running);
  const Flag idle = no_reset & (s.running == V(0));
  const Flag free = is_set(s.free);
  const Flag counted = s.free == V(0);
  const Flag none_x = s.left_x == V(0);
  const Flag none_y = s.left_y == V(0);
  const Flag done = counted & none_x & none_y;
  const Flag small = !(is_full(p, s.rate_x) | is_full(p, s.rate_y));
  const Flag shift = is_set(s.normalise) & small;
  const Flag drawing = running & !(done | shift);
  const Flag carry = !(s.sx + s.rate_x < V(shift_left(1, p.width)));
  const Flag borrow = s.sx + s.rate_x < V(0);
  const Flag write = is_set(in.write);
  const Flag start = is_set(in.start);
  return std::array<Stated<V>, 14>{
      {{"reset", reset},
       {"stop of a free curve", no_reset & stop & is_set(s.running) & free},
       {"stop of a counted curve", no_reset & stop & is_set(s.running) & counted},
       {"write", idle & write & !start},
       {"write and start at once", idle & write & start & !stop},
       {"start and stop at once", idle & start & stop},
       {"write while running", running & write},
       {"start while running", running & start},
       {"shift of the rates", shift & running & !done},
       {"step of X up", drawing & free & carry},
       {"step of X down", drawing & free & borrow},
       {"carry of an axis that is done", drawing & counted & none_x & carry},
       {"step of X that turns Y's rate at once", drawing & free & carry & is_set(s.sequential)},
       {"the end of the curve", running & done}}};
}

}  // namespace cosim::dda
