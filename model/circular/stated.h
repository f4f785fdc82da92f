// What is true of the circular machine's state at all times, and what may happen on a clock of it.
#pragma once

#include <array>

#include "model/circular/machine.h"
#include "model/core/stated.h"

namespace cosim::circular {

/// Nothing: RTL and model stay equal from every state that registers() can encode.
template <class V>
constexpr std::array<Stated<V>, 0> invariant(const Params&, const State<V>&) {
  return {};
}

/// True of every state after a reset, and no matter to RTL and model: what a mutant may rest on.
template <class V>
constexpr std::array<Stated<V>, 1> reached(const Params&, const State<V>& s) {
  return {
      {{"F has a fraction of 3/4 while no arc runs", is_set(s.t4) | (low_bits(s.f, 2) == V(3))}}};
}

/// The clocks as a proof takes them one by one, each without those before it: by what is added to
/// F.
template <class V>
constexpr std::array<Stated<V>, 6> parts(const Params&, const State<V>& s) {
  const Condition<V> sector2 = is_set(s.t16);
  const Condition<V> past = (s.ct8 < V(0)) & !sector2;
  return {{{"idle", s.t4 == V(0)},
           {"variant -1", past & bit(s.ct8, 0)},
           {"variant -2", past},
           {"straight in sector 1", (s.f > V(0)) & !sector2},
           {"diagonal in sector 1", !sector2},
           {"diagonal in sector 2", s.f > V(0)}}};
}

/// Each must be possible.
template <class V>
constexpr auto cases(const Params&, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag reset = is_set(in.rst);
  const Flag stop = is_set(in.stop) & is_set(s.t4) & !reset;
  const Flag quiet = !(reset | is_set(in.stop));
  const Flag running = quiet & is_set(s.t4);
  const Flag idle = quiet & !is_set(s.t4);
  const Flag sector2 = is_set(s.t16);
  const Flag end = s.ct7 < V(0);
  const Flag step = running & !end;
  const Flag past = s.ct8 < V(0);
  const Flag odd = bit(s.ct8, 0);
  const Flag outside = s.f > V(0);
  const Flag start = is_set(in.start);
  const Flag load = is_set(in.load);
  return std::array<Stated<V>, 17>{
      {{"reset", reset},
       {"stop in sector 1", stop & !sector2},
       {"stop in sector 2", stop & sector2},
       {"stop on the sector change", stop & !sector2 & past},
       {"load", idle & load & !start},
       {"load and start at once", idle & load & start},
       {"start in sector 1", idle & start & !sector2 & !is_set(in.sector2)},
       {"start in sector 2", idle & start & is_set(in.sector2)},
       {"load while running", running & load},
       {"start while running", running & start},
       {"straight step in sector 1", step & !sector2 & !past & outside},
       {"diagonal step in sector 1", step & !sector2 & !past & !outside},
       {"variant -1", step & !sector2 & past & odd},
       {"variant -2", step & !sector2 & past & !odd},
       {"straight step in sector 2", step & sector2 & !outside},
       {"diagonal step in sector 2", step & sector2 & outside},
       {"the end of the arc", running & end}}};
}

}  // namespace cosim::circular
