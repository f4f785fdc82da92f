// What is true of the circular machine's state at all times, and what must happen on a clock of it.
#pragma once

#include <array>

#include "model/circular/machine.h"
#include "model/core/stated.h"

namespace cosim::circular {

/// True of every state after a reset, and no matter to RTL and model: what a mutant may rest on.
template <class V>
constexpr std::array<Stated<V>, 1> reached(const Params&, const State<V>& s) {
  return {
      {{"F has a fraction of 3/4 while no arc runs", is_set(s.t4) | (low_bits(s.f, 2) == V(3))}}};
}

/// Each must be possible, and must happen under the stimuli.
template <class V>
constexpr auto cases(const Params& p, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag reset = is_set(in.rst);
  const Flag stop = is_set(in.stop) & !reset;
  const Flag quiet = !(reset | is_set(in.stop));
  const Flag waits = !is_set(s.t4);
  const Flag end = is_set(s.t4) & (s.ct7 < V(0));
  const Flag past = is_set(s.t4) & !end & !is_set(s.t16) & (s.ct8 < V(0));
  const Flag sector1 = is_set(s.t4) & !end & !is_set(s.t16) & !past;
  const Flag sector2 = is_set(s.t4) & !end & is_set(s.t16);
  const Flag odd = bit(s.ct8, 0);
  const Flag outside = s.f > V(0);
  const Flag start = is_set(in.start);
  const Flag load = is_set(in.load);
  const Flag begins = quiet & waits & start;
  const State<V> first = idle(p, s, in);
  const Flag in2 = is_set(first.t16);
  const Flag level = first.ct8 == V(0);
  const Flag from0 = begins & !in2 & (first.ct7 == V(0)) & level;
  return std::array<Stated<V>, 33>{
      {{"reset while idle", reset & waits},
       {"reset in sector 1", reset & sector1},
       {"reset in sector 2", reset & sector2},
       {"reset on the sector change", reset & past},
       {"reset at the end of an arc", reset & end},
       {"stop while idle", stop & waits},
       {"stop in sector 1", stop & sector1},
       {"stop in sector 2", stop & sector2},
       {"stop on the sector change", stop & past},
       {"stop at the end of an arc", stop & end},
       {"load", quiet & waits & load & !start},
       {"load and start at once", begins & load},
       {"load of the other zero", quiet & waits & load & (in.ct7 == V(ones(p.width + 1)))},
       {"start in sector 1", begins & !in2},
       {"start in sector 2", begins & in2},
       {"start with sector 2 set at once", begins & is_set(in.sector2)},
       {"start at X = Y", begins & in2 & level & !(first.ct7 < V(0))},
       // From (1, 0): F = R - 1.25 = -0.25.
       {"start of R = 1", from0 & (first.f == V(-1))},
       {"start with nothing loaded", from0 & (first.f == V(3))},
       {"start with CT7 < 0", begins & (first.ct7 < V(0))},
       {"load while running", quiet & !waits & load},
       {"start while running", quiet & !waits & start},
       {"sector 2 set while running in sector 1", quiet & sector1 & is_set(in.sector2)},
       {"straight step in sector 1", quiet & sector1 & outside},
       {"diagonal step in sector 1", quiet & sector1 & !outside},
       {"into variant -1 by a straight step", quiet & sector1 & outside & (s.ct8 == V(0))},
       {"into variant -1 by a diagonal step", quiet & sector1 & !outside & (s.ct8 == V(1))},
       {"into variant -2", quiet & sector1 & !outside & (s.ct8 == V(0))},
       {"variant -1", quiet & past & odd},
       {"variant -2", quiet & past & !odd},
       {"straight step in sector 2", quiet & sector2 & !outside},
       {"diagonal step in sector 2", quiet & sector2 & outside},
       {"the end of an arc", quiet & end}}};
}

}  // namespace cosim::circular
