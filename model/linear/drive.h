// The device outside, see model/core/job.h: SU 1631518. It writes BP and UK, starts the line and
// waits for its end: three clocks, one until the first word, one a word and one to see the end.
#pragma once

#include "model/core/job.h"
#include "model/linear/machine.h"

namespace cosim::linear {

struct Job;  // job.h

// clang-format off
/// What it is told of a line.
#define LINEAR_TASK(FIELD)                                                                         \
  FIELD(major,   p.m,         number, "14", "BP")                                                  \
  FIELD(code,    p.m,         bits,   "14", "UK")                                                  \
  FIELD(counted, 1,           flag,   "",   "give it up after so many words")                      \
  FIELD(words,   p.n + 1,     number, "",   "which no line has more of")

/// What it goes on from.
#define LINEAR_DRIVER(FIELD)                                                                       \
  FIELD(clock,   3,           number, "",   "0 to 3: writes BP, UK, starts, waits; 4: it runs")    \
  FIELD(words,   p.n + 1,     number, "",   "words seen so far")
// clang-format on

COSIM_RECORD(Task, LINEAR_TASK, Params);
COSIM_RECORD(Driver, LINEAR_DRIVER, Params);

Task<Word> task_of(const Params& p, const Job& job);

/// The inputs of the next clock.
template <class V>
constexpr Inputs<V> drive(const Params&, const Task<V>& t, const Driver<V>& d, Inputs<V> in) {
  const Condition<V> writes_bp = d.clock == V(0), writes_uk = d.clock == V(1);
  const Condition<V> runs = !(d.clock < V(4));
  in.initial_set_n = flag<V>(!(runs & is_set(t.counted) & !(d.words < t.words)));
  in.write_bp = flag<V>(writes_bp);
  in.write_uk = flag<V>(writes_uk);
  in.start = flag<V>(d.clock == V(2));
  in.data = select(writes_bp, t.major, select(writes_uk, t.code, V(0)));
  return in;
}

/// After a clock with these outputs. `busy` shows one clock after the start.
template <class V>
constexpr Turn<Driver, V> driven(const Params&, const Task<V>&, const Driver<V>& d,
                                 const Outputs<V>& seen) {
  const Condition<V> started = d.clock > V(2);
  const Condition<V> over = started & !is_set(seen.busy);
  return {{select(d.clock < V(4), d.clock + V(1), d.clock),
           select(started, d.words + seen.strobe, V(0))},
          over};
}

}  // namespace cosim::linear
