// Golden model of the circular interpolator, SU 1665343: one clock as a pure function, written from
// the mathematics. F, CT7 and CT8 are plain signed numbers here; registers() gives the codes that
// the RTL holds for them.
#pragma once

#include "model/circular/ones_complement.h"
#include "model/core/design.h"
#include "model/core/record.h"
#include "model/core/value.h"

namespace cosim::circular {

struct Params {
  int width = 16;  ///< bits of a coordinate, 2 to 32: arcs with round(R) < 2^width
};

// clang-format off
#define CIRCULAR_INPUTS(FIELD)                                                                     \
  FIELD(rst,     1,           flag,            "",   "clear everything")                           \
  FIELD(load,    1,           flag,            "",   "take f, ct7, ct8 while idle")                \
  FIELD(f,       p.width + 2, twos_complement, "29", "floor of F at the start")                    \
  FIELD(ct7,     p.width + 1, ones_complement, "30", "Y in sector 1, X - 1 in sector 2")           \
  FIELD(ct8,     p.width + 1, ones_complement, "31", "X - Y - 1 in sector 1, X - Y in sector 2")   \
  FIELD(sector2, 1,           flag,            "34", "start in sector 2, while idle")              \
  FIELD(start,   1,           flag,            "33", "start, while idle")                          \
  FIELD(stop,    1,           flag,            "32", "end of work: clear everything, no step")

#define CIRCULAR_OUTPUTS(FIELD)                                                                    \
  FIELD(running, 1,           flag,            "4",  "an arc is being drawn")                      \
  FIELD(step_y,  1,           flag,            "35", "Y + 1 on this clock")                        \
  FIELD(step_x,  1,           flag,            "36", "X - 1 on this clock")

// The registers, by the same names in the model's state (numbers, F in quarters) and in the RTL
// (codes).
#define CIRCULAR_REGISTERS(FIELD)                                                                  \
  FIELD(t4,      1,           flag,            "4",  "running")                                    \
  FIELD(t16,     1,           flag,            "16", "sector 2")                                   \
  FIELD(f,       p.width + 4, ones_complement.with_fraction(2), "1", "evaluation function F")      \
  FIELD(ct7,     p.width + 1, ones_complement, "7",  "Y in sector 1, X - 1 in sector 2")           \
  FIELD(ct8,     p.width + 1, ones_complement, "8",  "X - Y - 1 in sector 1, X - Y in sector 2")
// clang-format on

COSIM_RECORD(Inputs, CIRCULAR_INPUTS, Params);
COSIM_RECORD(Outputs, CIRCULAR_OUTPUTS, Params);
COSIM_RECORD(State, CIRCULAR_REGISTERS, Params);
COSIM_REGISTERS(Registers, CIRCULAR_REGISTERS, Params);

/// The state after a reset. F is +0.75: its fraction is wired.
template <class V>
constexpr State<V> reset_state() {
  State<V> s{V(0), V(0), V(3), V(0), V(0)};
  return s;
}

template <class V>
using Step = StepOf<State<V>, Outputs<V>>;

/// The state after a step with F's sign and the sector as given.
template <class V>
constexpr State<V> stepped(const Params& p, const State<V>& s, Condition<V> diagonal) {
  const Condition<V> sector2 = is_set(s.t16);
  State<V> n = s;
  n.ct7 = wrap_end_around(s.ct7 + select(sector2, V(-1), V(1)), p.width + 1);
  n.ct8 = wrap_end_around(s.ct8 - select(diagonal, V(2), V(1)), p.width + 1);

  // 2(X' - Y') - 1 after a diagonal step; -(2Y' + 1) or 2X' - 1 after a straight one. Where a
  // loaded value has gone out of range the machine's codes give the numbers in the second place.
  const V twice7 = n.ct7 + n.ct7;
  const V twice8 = n.ct8 + n.ct8;
  const V to_y = select(n.ct7 < V(0), V(0) - twice7, V(-1) - twice7);
  const V to_both = select(sector2, select(n.ct8 < V(0), twice8 - V(1), twice8), twice8 + V(1));
  const V whole = select(diagonal, to_both, select(sector2, twice7 + V(1), to_y));
  n.f = wrap_end_around(s.f + shift_left(whole, 2), p.width + 4);
  return n;
}

/// The state after the correction that follows the step into sector 2: F gains X + Y, CT7 passes
/// from Y to X - 1, CT8 from X - Y - 1 to X - Y. CT8 is -1 (X = Y) or -2 (X = Y - 1); what else a
/// load may have put there counts as the one of its parity.
template <class V>
constexpr State<V> corrected(const Params& p, const State<V>& s) {
  const Condition<V> level = bit(s.ct8, 0);  // X = Y: variant -1
  const V x = s.ct7 - select(level, V(0), V(1));
  State<V> n = s;
  n.t16 = V(1);
  n.ct7 = x - V(1);
  n.ct8 = select(level, V(0), V(-1));
  n.f = wrap_end_around(s.f + shift_left(x + x + select(level, V(0), V(1)), 2), p.width + 4);
  return n;
}

/// The state after a clock on which no arc runs.
template <class V>
constexpr State<V> idle(const Params& p, const State<V>& s, const Inputs<V>& in) {
  const Condition<V> load = is_set(in.load);
  State<V> n = s;
  n.t4 = in.start;
  n.t16 = flag<V>(is_set(s.t16) | is_set(in.sector2));
  n.f = select(load, shift_left(from_twos_complement(in.f, p.width + 2), 2) + V(3), s.f);
  n.ct7 = select(load, from_ones_complement(in.ct7, p.width + 1), s.ct7);
  n.ct8 = select(load, from_ones_complement(in.ct8, p.width + 1), s.ct8);
  return n;
}

/// One clock. Total: any state that registers() can encode, any inputs.
template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag running = is_set(s.t4);
  const Flag sector2 = is_set(s.t16);
  const Flag stop = is_set(in.stop);
  const Flag finish = running & (s.ct7 < V(0));
  const Flag correct = running & !sector2 & (s.ct8 < V(0));
  const Flag step = running & !finish & !correct & !stop;

  // F is the midpoint test of the next two candidates. Negative: the midpoint is outside the
  // circle, so the inner one is next; that is the diagonal step in sector 1, the straight one in 2.
  const Flag negative = !(s.f > V(0));
  const Flag diagonal = (sector2 & !negative) | (negative & !sector2);

  Step<V> result;
  result.outputs.running = s.t4;
  result.outputs.step_y = flag<V>(step & (diagonal | !sector2));
  result.outputs.step_x = flag<V>(step & (diagonal | sector2));
  result.state = if_else(
      is_set(in.rst) | stop | finish, [&] { return reset_state<V>(); },
      [&] {
        return if_else(
            running,
            [&] {
              return if_else(
                  correct, [&] { return corrected(p, s); },
                  [&] { return stepped(p, s, diagonal); });
            },
            [&] { return idle(p, s, in); });
      });
  return result;
}

/// The codes the RTL's registers hold in state s.
template <class V>
constexpr Registers<V> registers(const Params& p, const State<V>& s) {
  Registers<V> r;
  r.t4 = s.t4;
  r.t16 = s.t16;
  r.f = to_ones_complement_minus_zero(s.f, p.width + 4);
  r.ct7 = to_ones_complement(s.ct7, p.width + 1);
  r.ct8 = to_ones_complement(s.ct8, p.width + 1);
  return r;
}

// What it is given to do, and the device outside: job.h. What a person wants to see of it: view.h.
struct Arc;
using Job = Arc;
COSIM_JOB_TYPES;

/// The design as one type, for code that is generic over designs.
struct Design {
  COSIM_DESIGN(circular);
  COSIM_DESIGN_JOBS(circular);
  /// Of a job: there are none that wait for ever.
  static constexpr std::uint64_t most_clocks = std::uint64_t{1} << 40;
  static constexpr const char* name = "circular";
  static constexpr const char* source = "SU 1665343";

  /// The parameters by the RTL's names.
  static constexpr std::array<Parameter, 1> parameters(const Params& p) {
    return {{{"W", p.width}}};
  }
  /// Inputs of a clock that clears every register, whatever it held.
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
  template <class V>
  static constexpr State<V> reset_state() {
    return circular::reset_state<V>();
  }
};

}  // namespace cosim::circular

// Beside the step, found by its name: whoever has the design has this too. Else a template of both
// would be another one where it is missing.
#include "model/circular/stated.h"
