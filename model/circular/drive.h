// The device outside, see model/core/job.h: SU 1665343. It loads an arc, starts it, and waits for
// its end or stops it: one clock to load and start, then one a step, one more for a sector change
// and one or two to end.
#pragma once

#include "model/circular/arc.h"
#include "model/circular/machine.h"
#include "model/core/job.h"

namespace cosim::circular {

// clang-format off
/// What it is told of an arc.
#define CIRCULAR_TASK(FIELD)                                                                       \
  FIELD(sector2, 1,           flag,            "34", "start in sector 2")                          \
  FIELD(f,       p.width + 2, bits,            "29", "the words to load")                          \
  FIELD(ct7,     p.width + 1, bits,            "30", "")                                           \
  FIELD(ct8,     p.width + 1, bits,            "31", "")                                           \
  FIELD(counted, 1,           flag,            "",   "end it after so many steps")                 \
  FIELD(count,   p.width + 2, number,          "",   "which no arc has more of")

/// What it goes on from.
#define CIRCULAR_DRIVER(FIELD)                                                                     \
  FIELD(begun,   1,           flag,            "",   "the arc was started")                        \
  FIELD(steps,   p.width + 2, number,          "",   "steps seen so far")
// clang-format on

COSIM_RECORD(Task, CIRCULAR_TASK, Params);
COSIM_RECORD(Driver, CIRCULAR_DRIVER, Params);

Task<Word> task_of(const Params& p, const Arc& arc);

/// The inputs of the next clock.
template <class V>
constexpr Inputs<V> drive(const Params&, const Task<V>& t, const Driver<V>& d, Inputs<V> rest) {
  return if_else(
      is_set(d.begun),
      [&] {
        Inputs<V> in = rest;
        in.stop = flag<V>(is_set(t.counted) & !(d.steps < t.count));
        return in;
      },
      [&] {
        Inputs<V> in = rest;
        in.load = in.start = V(1);
        in.sector2 = t.sector2;
        in.f = t.f;
        in.ct7 = t.ct7;
        in.ct8 = t.ct8;
        return in;
      });
}

/// After a clock with these outputs.
template <class V>
constexpr Turn<Driver, V> driven(const Params&, const Task<V>&, const Driver<V>& d,
                                 const Outputs<V>& seen) {
  const Condition<V> begun = is_set(d.begun);
  const Condition<V> over = begun & !is_set(seen.running);
  return {{V(1), select(begun, d.steps + (seen.step_y | seen.step_x), V(0))}, over};
}

}  // namespace cosim::circular
