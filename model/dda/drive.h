// The device outside, see model/core/job.h. It writes the registers for a curve, starts it, and
// waits for its end or stops it: twelve clocks to write and start, those it runs, and one or two to
// end.
#pragma once

#include <algorithm>

#include "model/core/job.h"
#include "model/dda/curve.h"
#include "model/dda/machine.h"

namespace cosim::dda {

/// How many words are written: the modes, and every register behind them.
inline constexpr int addresses = State<Word>::size - State<Word>::index_sx + 1;

/// Bits that count the clocks of a job in a lane: of an arc and of a circle, and of 2^13 clocks of
/// anything.
constexpr int clock_bits(int width) { return std::max(width + 4, 14); }

// clang-format off
/// What it is told of a job.
#define DDA_TASK(FIELD)                                                                            \
  FIELD(words,   p.width + 1,         bits.array<12>(), "", "what is written, by address")         \
  FIELD(counted, 1,                   flag,             "", "stop it after so many clocks")        \
  FIELD(clocks,  clock_bits(p.width), number,           "", "")

/// What it goes on from.
#define DDA_DRIVER(FIELD)                                                                          \
  FIELD(written, 4,                   number,           "", "addresses that were written")         \
  FIELD(clocks,  clock_bits(p.width), number,           "", "of running so far")
// clang-format on

COSIM_RECORD(Task, DDA_TASK, Params);
COSIM_RECORD(Driver, DDA_DRIVER, Params);
static_assert(addresses == 12);

Task<Word> task_of(const Params& p, const Job& job);

/// The inputs of the next clock.
template <class V>
constexpr Inputs<V> drive(const Params&, const Task<V>& t, const Driver<V>& d, Inputs<V> rest) {
  return if_else(
      d.written < V(addresses),
      [&] {
        Inputs<V> in = rest;
        in.write = V(1);
        in.address = d.written;
        for (int i = 0; i < addresses; ++i) {
          in.data = select(d.written == V(i), t.words[i], in.data);
        }
        in.start = flag<V>(d.written == V(addresses - 1));
        return in;
      },
      [&] {
        Inputs<V> in = rest;
        in.stop = flag<V>(is_set(t.counted) & !(d.clocks < t.clocks));
        return in;
      });
}

/// After a clock with these outputs. The start shows in `busy` on the next one.
template <class V>
constexpr Turn<Driver, V> driven(const Params&, const Task<V>&, const Driver<V>& d,
                                 const Outputs<V>& seen) {
  const Condition<V> writes = d.written < V(addresses);
  const Condition<V> over = !writes & !is_set(seen.busy);
  return {
      {select(writes, d.written + V(1), d.written), select(writes | over, V(0), d.clocks + V(1))},
      over};
}

}  // namespace cosim::dda
