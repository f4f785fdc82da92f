// Golden model of the interpolator by the method of differential increments, a DDA: one clock as a
// pure function, written from the mathematics. Rates, codes and coefficients are plain signed
// numbers here; registers() gives the two's complement that the RTL holds for them.
//
// Each register holds any number of its width in any state: there is no invariant between them.
#pragma once

#include "model/core/design.h"
#include "model/core/record.h"
#include "model/core/value.h"

namespace cosim::dda {

struct Params {
  int width = 16;  ///< bits of an accumulator, 2 to 32: rates stay within 2^width in size
};

// clang-format off
#define DDA_INPUTS(FIELD)                                                                          \
  FIELD(rst,        1,           flag,            "",   "clear every register")                    \
  FIELD(write,      1,           flag,            "",   "take data while idle")                    \
  FIELD(address,    4,           number,          "",   "the register to write, see Address")      \
  FIELD(data,       p.width + 1, bits,            "",   "what is written")                         \
  FIELD(start,      1,           flag,            "",   "start, while idle")                       \
  FIELD(stop,       1,           flag,            "",   "stop, no step")

#define DDA_OUTPUTS(FIELD)                                                                         \
  FIELD(busy,       1,           flag,            "",   "a curve is being drawn")                  \
  FIELD(x_up,       1,           flag,            "",   "X + 1 on this clock: a carry of SX")      \
  FIELD(x_down,     1,           flag,            "",   "X - 1 on this clock: a borrow of SX")     \
  FIELD(y_up,       1,           flag,            "",   "Y + 1 on this clock")                     \
  FIELD(y_down,     1,           flag,            "",   "Y - 1 on this clock")                     \
  FIELD(code_x,     p.width + 1, twos_complement, "",   "X before this clock's step")              \
  FIELD(code_y,     p.width + 1, twos_complement, "",   "Y before this clock's step")

// The registers, by the same names in the model's state (numbers) and in the RTL (codes). The modes
// stand in the order of their bits in the word at address 0, the others in that of their addresses,
// 1 and on.
#define DDA_REGISTERS(FIELD)                                                                       \
  FIELD(running,    1,           flag,            "",   "a curve is being drawn")                  \
  FIELD(sequential, 1,           flag,            "",   "Y's rate follows the step of X at once")  \
  FIELD(normalise,  1,           flag,            "",   "shift the rates up before the first step") \
  FIELD(free,       1,           flag,            "",   "no count of steps: run until a stop")     \
  FIELD(sx,         p.width,     number,          "SX", "accumulator of X")                        \
  FIELD(sy,         p.width,     number,          "SY", "accumulator of Y")                        \
  FIELD(rate_x,     p.width + 1, twos_complement, "P1", "x' = -(B x + 2 C y + E)")                 \
  FIELD(rate_y,     p.width + 1, twos_complement, "P2", "y' = 2 A x + B y + D")                    \
  FIELD(x,          p.width + 1, twos_complement, "P3", "the point")                               \
  FIELD(y,          p.width + 1, twos_complement, "P4", "the point")                               \
  FIELD(left_x,     p.width,     number,          "P5", "steps of X left")                         \
  FIELD(left_y,     p.width,     number,          "P6", "steps of Y left")                         \
  FIELD(two_a,      p.width + 1, twos_complement, "",   "2 A: by which a step of X changes Y's rate") \
  FIELD(b,          p.width + 1, twos_complement, "",   "B: by which a step changes its own rate") \
  FIELD(two_c,      p.width + 1, twos_complement, "",   "2 C: by which a step of Y changes X's rate")
// clang-format on

COSIM_RECORD(Inputs, DDA_INPUTS, Params);
COSIM_RECORD(Outputs, DDA_OUTPUTS, Params);
COSIM_RECORD(State, DDA_REGISTERS, Params);
COSIM_REGISTERS(Registers, DDA_REGISTERS, Params);

template <class V>
using Step = StepOf<State<V>, Outputs<V>>;

/// The bits that a field's code has, as the number that it stands for.
template <class V>
constexpr V value_of(const Field& field, V code) {
  const V bits = low_bits(code, field.width);
  return field.format == Format::twos_complement ? from_twos_complement(bits, field.width) : bits;
}

/// A rate, a code or a coefficient wrapped to its register.
template <class V>
constexpr V wrap_signed(const Params& p, V v) {
  return from_twos_complement(low_bits(v, p.width + 1), p.width + 1);
}

/// A step of one axis: a carry or a borrow of its accumulator. Flags, not both of them 1.
template <class V>
struct Increment {
  V up, down;

  /// The number by which a step up changes something, for the step that there is.
  constexpr V times(V by) const {
    return select(is_set(up), by, select(is_set(down), V(0) - by, V(0)));
  }
};

template <class V>
constexpr Increment<V> increment(const Params& p, V sum, Condition<V> may_step) {
  const Condition<V> carry = !(sum < V(shift_left(1, p.width)));
  const Condition<V> borrow = sum < V(0);
  return {flag<V>(may_step & carry), flag<V>(may_step & borrow)};
}

/// Whether a rate has half of the accumulator or more.
template <class V>
constexpr Condition<V> is_full(const Params& p, V rate) {
  const V half = V(shift_left(1, p.width - 1));
  const Condition<V> small = (rate < half) & (rate > V(0) - half);
  return !small;
}

/// The state after the rates were added, and the steps that come of it.
template <class V>
struct Advance {
  State<V> state;
  Increment<V> x, y;
};

template <class V>
constexpr Advance<V> advanced(const Params& p, const State<V>& s) {
  const Condition<V> free = is_set(s.free);
  const Condition<V> counted = !free;
  const V sum_x = s.sx + s.rate_x;
  const Increment<V> x = increment(p, sum_x, free | !(s.left_x == V(0)));
  const V turned = wrap_signed(p, s.rate_y + x.times(s.two_a));
  const V sum_y = s.sy + select(is_set(s.sequential), turned, s.rate_y);
  const Increment<V> y = increment(p, sum_y, free | !(s.left_y == V(0)));

  State<V> n = s;
  n.sx = wrap(sum_x, p.width);
  n.sy = wrap(sum_y, p.width);
  n.rate_x = wrap_signed(p, s.rate_x - x.times(s.b) - y.times(s.two_c));
  n.rate_y = wrap_signed(p, turned + y.times(s.b));
  n.x = wrap_signed(p, s.x + x.up - x.down);
  n.y = wrap_signed(p, s.y + y.up - y.down);
  n.left_x = s.left_x - select(counted, x.up + x.down, V(0));
  n.left_y = s.left_y - select(counted, y.up + y.down, V(0));
  return {n, x, y};
}

/// The state after a clock that shifts the rates.
template <class V>
constexpr State<V> shifted(const State<V>& s) {
  State<V> n = s;
  n.rate_x = s.rate_x + s.rate_x;
  n.rate_y = s.rate_y + s.rate_y;
  return n;
}

/// The state after a clock on which no curve is drawn.
template <class V>
constexpr State<V> idle(const Params& p, const State<V>& s, const Inputs<V>& in) {
  State<V> n = s;
  n.running = flag<V>(is_set(in.start) & !is_set(in.stop));
  return if_else(
      is_set(in.write),
      [&] {
        State<V> w = n;
        const Condition<V> modes = in.address == V(0);
        w.sequential = select(modes, flag<V>(bit(in.data, 0)), s.sequential);
        w.normalise = select(modes, flag<V>(bit(in.data, 1)), s.normalise);
        w.free = select(modes, flag<V>(bit(in.data, 2)), s.free);
        constexpr auto first = State<V>::index_sx;
        const auto fields = State<V>::fields(p);
        for_each_member<State<V>>([&](auto member, std::size_t i) {
          if (i < first) return;
          const V address = V(static_cast<int>(i - first) + 1);
          w.*member = select(in.address == address, value_of(fields[i], in.data), s.*member);
        });
        return w;
      },
      [&] { return n; });
}

/// One clock. Total: any state that registers() can encode, any inputs.
template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag running = is_set(s.running);
  const Flag counted = !is_set(s.free);
  const Flag done = counted & (s.left_x == V(0)) & (s.left_y == V(0));
  const Flag over = is_set(in.stop) | done;
  const Flag shift = is_set(s.normalise) & !is_full(p, s.rate_x) & !is_full(p, s.rate_y);
  const Flag step = running & !over & !shift;
  const Advance<V> a = advanced(p, s);

  Step<V> result;
  result.outputs.busy = s.running;
  result.outputs.x_up = select(step, a.x.up, V(0));
  result.outputs.x_down = select(step, a.x.down, V(0));
  result.outputs.y_up = select(step, a.y.up, V(0));
  result.outputs.y_down = select(step, a.y.down, V(0));
  result.outputs.code_x = low_bits(s.x, p.width + 1);
  result.outputs.code_y = low_bits(s.y, p.width + 1);
  result.state = if_else(
      is_set(in.rst), [] { return State<V>{}; },
      [&] {
        return if_else(
            running,
            [&] {
              State<V> stopped = s;
              stopped.running = V(0);
              return select(over, stopped, select(shift, shifted(s), a.state));
            },
            [&] { return idle(p, s, in); });
      });
  return result;
}

/// The codes the RTL's registers hold in state s.
template <class V>
constexpr Registers<V> registers(const Params& p, const State<V>& s) {
  Registers<V> r;
  const auto fields = State<V>::fields(p);
  const auto numbers = State<V>::members();
  for_each_member<Registers<V>>([&](auto member, std::size_t i) {
    const V number = s.*numbers[i];
    const bool is_signed = fields[i].format == Format::twos_complement;
    r.*member = is_signed ? low_bits(number, fields[i].width) : number;
  });
  return r;
}

// What it is given to do, and the device outside: job.h. What a person wants to see of it: view.h.
struct Job;
COSIM_JOB_TYPES;

/// The design as one type, for code that is generic over designs.
struct Design {
  COSIM_DESIGN(dda);
  COSIM_DESIGN_JOBS(dda);
  /// Of a job: there are none that wait for ever.
  static constexpr std::uint64_t most_clocks = std::uint64_t{1} << 40;
  static constexpr const char* name = "dda";
  static constexpr const char* source = "the method of differential increments";

  /// The parameters by the RTL's names.
  static constexpr std::array<Parameter, 1> parameters(const Params& p) {
    return {{{"W", p.width}}};
  }
  /// Inputs of a clock that clears every register, whatever it held.
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
};

}  // namespace cosim::dda

// Beside the step, found by its name: whoever has the design has this too. Else a template of both
// would be another one where it is missing.
#include "model/dda/stated.h"
