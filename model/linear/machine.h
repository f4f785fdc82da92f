// Golden model of the linear interpolator, SU 1631518: one clock as a pure function, written from
// the mathematics. The state counts positions of the line that are left; registers() gives what the
// RTL's counter, remainder register and multiplier hold for it.
#pragma once

#include "model/core/design.h"
#include "model/core/record.h"
#include "model/core/value.h"
#include "model/linear/reversed.h"

namespace cosim::linear {

struct Params {
  int m = 5;  ///< bits of BP and of the code UK, 2 to 32
  int n = 2;  ///< low bits of UK that the serial multiplier takes, 1 to m - 1
  constexpr int gamma() const { return m - n; }        ///< 1 to 6
  constexpr int word() const { return 1 << gamma(); }  ///< positions in a word
};

// clang-format off
#define LINEAR_INPUTS(FIELD)                                                                       \
  FIELD(initial_set_n, 1,            flag,   "17", "active low: forget the line, keep the code")   \
  FIELD(reset,         1,            flag,   "26", "clear everything")                             \
  FIELD(write_bp,      1,            flag,   "15", "take BP from data while idle")                 \
  FIELD(write_uk,      1,            flag,   "16", "take UK from data while idle")                 \
  FIELD(start,         1,            flag,   "18", "start, while idle and a code is written")      \
  FIELD(data,          p.m,          number, "14", "BP or UK; the high bit of UK is a_1")

#define LINEAR_OUTPUTS(FIELD)                                                                      \
  FIELD(busy,          1,            flag,   "22", "a line is being drawn")                        \
  FIELD(strobe,        1,            flag,   "23", "minor and major hold a pair of words")         \
  FIELD(minor,         p.word(),     bits,   "24", "minor axis, position 1 leftmost")              \
  FIELD(major,         p.word(),     bits,   "25", "major axis, position 1 leftmost")

#define LINEAR_STATE(FIELD)                                                                        \
  FIELD(running,       1,            flag,   "",   "a line is being drawn")                        \
  FIELD(formed,        1,            flag,   "",   "a pair of words is formed and on the outputs") \
  FIELD(coded,         1,            flag,   "",   "a code was written for the present BP")        \
  FIELD(left,          p.m,          number, "",   "positions of the line not yet put out")        \
  FIELD(tick,          p.n,          number, "",   "words formed, modulo 2^n")                     \
  FIELD(low_code,      p.n,          bits,   "",   "a_(gamma+1) .. a_m")                           \
  FIELD(pattern,       p.word() - 1, bits,   "",   "minor steps of positions 1 .. 2^gamma - 1")    \
  FIELD(last_bit,      1,            flag,   "",   "minor step of position 2^gamma")

#define LINEAR_REGISTERS(FIELD)                                                                    \
  FIELD(trigger30,     1,            flag,   "30", "a pair of words is formed")                    \
  FIELD(trigger31,     1,            flag,   "31", "running")                                      \
  FIELD(trigger32,     1,            flag,   "32", "a code was written for the present BP")        \
  FIELD(counter4,      p.n + 1,      number, "4",  "words still to form")                          \
  FIELD(register5,     p.gamma(),    number, "5",  "BP modulo 2^gamma")                            \
  FIELD(multiplier6,   p.n, number.at("multiplier6.ticks_q"), "6", "words formed, modulo 2^n")     \
  FIELD(register3,     p.n,          bits,   "3",  "low bits of UK")                               \
  FIELD(register9,     p.word() - 1, bits,   "9",  "word of ROM 2 for the high bits of UK")        \
  FIELD(trigger10,     1,            flag,   "10", "bit of multiplier 6 for this word")
// clang-format on

COSIM_RECORD(Inputs, LINEAR_INPUTS, Params);
COSIM_RECORD(Outputs, LINEAR_OUTPUTS, Params);
COSIM_RECORD(State, LINEAR_STATE, Params);
COSIM_REGISTERS(Registers, LINEAR_REGISTERS, Params);

template <class V>
using Step = StepOf<State<V>, Outputs<V>>;

/// The word with a one in each live position: the first `left` of 2^gamma, all where left is more.
template <class V>
constexpr V live_positions(const Params& p, V left) {
  return if_else(
      left < V(p.word()),
      [&] {
        V word = V(0);
        for (int q = 1; q <= p.word(); ++q) {
          word = shift_left(word, 1) + select(left < V(q), V(0), V(1));
        }
        return word;
      },
      [&] { return V(ones(p.word())); });
}

/// The minor steps of positions 1 .. 2^gamma - 1 of every word: position q takes the code's bit a_i
/// with q = 2^(i-1) * odd.
template <class V>
constexpr V pattern_of(const Params& p, V code) {
  V word = V(0);
  for (int q = 1; q < p.word(); ++q) {
    int i = 1;
    while ((q >> i) << i == q) ++i;
    word = shift_left(word, 1) + select(bit(code, p.m - i), V(1), V(0));
  }
  return word;
}

/// The minor step of position k * 2^gamma, k modulo 2^n: the bit of low_code whose index is the
/// place of k's lowest one; none where k is 0.
template <class V>
constexpr V last_bit_of(const Params& p, V low_code, V k) {
  const V lowest_one = k & (V(shift_left(1, p.n)) - k);
  return flag<V>(is_set(lowest_one & reversed(low_code, p.n)));
}

/// The state with no line, keeping the code.
template <class V>
constexpr State<V> at_rest(State<V> s) {
  s.running = s.formed = s.coded = s.left = s.tick = s.last_bit = V(0);
  return s;
}

/// The state after a clock of a running line: the word on the outputs, if there is one, is put out;
/// the next one is formed, or the line is over.
template <class V>
constexpr State<V> advanced(const Params& p, const State<V>& s) {
  const V word = V(p.word());
  const V left = select(is_set(s.formed), select(s.left < word, V(0), s.left - word), s.left);
  return if_else(
      left == V(0), [&] { return at_rest(s); },
      [&] {
        State<V> n = s;
        n.left = left;
        n.formed = V(1);
        n.tick = wrap(s.tick + V(1), p.n);
        n.last_bit = last_bit_of(p, s.low_code, n.tick);
        return n;
      });
}

/// The state after a clock on which no line runs. BP wins over UK, a write over a start.
template <class V>
constexpr State<V> idle(const Params& p, const State<V>& s, const Inputs<V>& in) {
  return if_else(
      is_set(in.write_bp),
      [&] {
        State<V> n = s;
        n.left = in.data;
        n.coded = V(0);
        return n;
      },
      [&] {
        return if_else(
            is_set(in.write_uk),
            [&] {
              State<V> n = s;
              n.low_code = low_bits(in.data, p.n);
              n.pattern = pattern_of(p, in.data);
              n.coded = V(1);
              return n;
            },
            [&] {
              State<V> n = s;
              n.running = flag<V>(is_set(in.start) & is_set(s.coded));
              return n;
            });
      });
}

/// One clock. Total: any state that registers() can encode, any inputs.
template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  Step<V> result;
  result.outputs.busy = s.running;
  result.outputs.strobe = s.formed;
  result.outputs.major = if_else(
      is_set(s.formed), [&] { return live_positions(p, s.left); }, [] { return V(0); });
  result.outputs.minor = (shift_left(s.pattern, 1) + s.last_bit) & result.outputs.major;
  result.state = if_else(
      is_set(in.reset), [] { return State<V>{}; },
      [&] {
        return if_else(
            !is_set(in.initial_set_n), [&] { return at_rest(s); },
            [&] {
              return if_else(
                  is_set(s.running), [&] { return advanced(p, s); },
                  [&] { return idle(p, s, in); });
            });
      });
  return result;
}

/// The codes the RTL's registers hold in state s.
template <class V>
constexpr Registers<V> registers(const Params& p, const State<V>& s) {
  const Condition<V> part = !(low_bits(s.left, p.gamma()) == V(0));
  Registers<V> r;
  r.trigger30 = s.formed;
  r.trigger31 = s.running;
  r.trigger32 = s.coded;
  r.counter4 = shift_right(s.left, p.gamma()) + flag<V>(part & is_set(s.coded)) - s.formed;
  r.register5 = low_bits(s.left, p.gamma());
  r.multiplier6 = s.tick;
  r.register3 = s.low_code;
  r.register9 = s.pattern;
  r.trigger10 = s.last_bit;
  return r;
}

// What it is given to do, and the device outside: job.h. What a person wants to see of it: view.h.
struct Job;
COSIM_JOB_TYPES;

/// The design as one type, for code that is generic over designs.
struct Design {
  COSIM_DESIGN(linear);
  COSIM_DESIGN_JOBS(linear);
  /// Of a job: there are none that wait for ever.
  static constexpr std::uint64_t most_clocks = std::uint64_t{1} << 40;
  static constexpr const char* name = "linear";
  static constexpr const char* source = "SU 1631518";

  /// The parameters by the RTL's names.
  static constexpr std::array<Parameter, 2> parameters(const Params& p) {
    return {{{"M", p.m}, {"N", p.n}}};
  }
  /// Inputs of a clock on which nothing is asked of the machine.
  static constexpr Inputs<Word> rest() {
    Inputs<Word> in;
    in.initial_set_n = 1;
    return in;
  }
  /// Inputs of a clock that clears every register, whatever it held.
  static constexpr Inputs<Word> reset_inputs() {
    Inputs<Word> in = rest();
    in.reset = 1;
    return in;
  }
};

}  // namespace cosim::linear

// Beside the step, found by its name: whoever has the design has this too. Else a template of both
// would be another one where it is missing.
#include "model/linear/stated.h"
