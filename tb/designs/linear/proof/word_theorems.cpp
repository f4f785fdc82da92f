// SU 1631518: a line from its start to its end, at every width that is shipped. Position q >= 1 of
// a line belongs to bit i of the code, a_i, where q = 2^(i-1) * odd.
#include <array>

#include "model/linear/machine.h"
#include "tb/designs/linear/proof/theorems.h"
#include "tb/proof/widths.h"

namespace cosim::linear {
namespace {

using namespace proof;

Params params(const Widths& widths) {
  return {static_cast<int>(widths[0].value), static_cast<int>(widths[1].value)};
}

// The machine with T words put out of BP positions and the code C: the next word is formed, or not
// yet.
State<BitVector> on_its_way(const Params& p, const BitVector& bp, const BitVector& words,
                            const BitVector& code, const BitVector& formed,
                            const BitVector& last_bit) {
  State<BitVector> s;
  s.running = s.coded = BitVector(1);
  s.formed = formed;
  s.left = bp - shift_left(words, p.gamma());
  s.tick = low_bits(words + formed, p.n);
  s.low_code = low_bits(code, p.n);
  s.pattern = pattern_of(p, code);
  s.last_bit = last_bit;
  return s;
}

struct Line {
  BitVector bp, words, code;
  State<BitVector> state;
  Truth holds = true;
};

// What follows a clock is to be this again, for one word more.
Truth formed_right(const Params& p, const State<BitVector>& s) {
  return (s.last_bit == last_bit_of(p, s.low_code, s.tick)) | !is_set(s.formed);
}

// Any line, anywhere on its way.
Line any_line(const Params& p, Script& script) {
  Line a;
  a.bp = free_number(script, "BP", p.m);
  a.words = free_number(script, "T", p.n + 1);
  a.code = free_number(script, "C", p.m);
  const BitVector formed = free_number(script, "formed", 1);
  a.state = on_its_way(p, a.bp, a.words, a.code, formed, free_number(script, "last_bit", 1));
  // Before the first word none is put out; behind that each has positions.
  a.holds = (a.state.left > BitVector(0)) & ((a.words == BitVector(0)) | is_set(formed)) &
            formed_right(p, a.state);
  return a;
}

Truth same(const State<BitVector>& a, const State<BitVector>& b) {
  Truth all = true;
  for_each_member<State<BitVector>>(
      [&](auto member, std::size_t) { all = all & (a.*member == b.*member); });
  return all;
}

Inputs<BitVector> pins_at_rest() {
  Inputs<BitVector> in;
  in.initial_set_n = BitVector(1);
  return in;
}

// From a machine at rest, whatever code it keeps: two writes and a start, and a clock more.
Asked line_begins(const Widths& widths) {
  const Params p = params(widths);
  Script script("QF_BV");
  const BitVector bp = free_number(script, "BP", p.m), code = free_number(script, "C", p.m);
  State<BitVector> rest;
  rest.low_code = free_number(script, "low_code", p.n);
  rest.pattern = free_number(script, "pattern", p.word() - 1);
  std::array<Inputs<BitVector>, 4> pins;
  pins.fill(pins_at_rest());
  pins[0].write_bp = pins[1].write_uk = pins[2].start = BitVector(1);
  pins[0].data = bp;
  pins[1].data = code;

  State<BitVector> s = rest, started;
  Truth strobe = false;
  for (const auto& in : pins) {
    started = s;  // in the end the state that the start left
    const auto step = next(p, s, in);
    strobe = strobe | is_set(step.outputs.strobe);
    s = step.state;
  }
  const Truth begun =
      same(started, on_its_way(p, bp, BitVector(0), code, BitVector(0), BitVector(0)));
  const Truth over = same(s, at_rest(started)) | (bp > BitVector(0));
  return {script, strobe | !(begun & over)};
}

// Whether minor steps at position q: the bit of the code that it belongs to.
Truth belongs(const Params& p, const BitVector& code, const BitVector& q) {
  Truth any = false;
  for (int i = 1; i <= p.m; ++i) {
    const Truth here = low_bits(q, i) == BitVector(cosim::shift_left(1, i - 1));
    any = any | (here & bit(code, p.m - i));
  }
  return any;
}

Truth differ(const Truth& a, const Truth& b) { return (a & !b) | (b & !a); }

// The strobe is up: the words hold positions T 2^gamma + 1 and on.
Asked words_hold(const Widths& widths) {
  const Params p = params(widths);
  Script script("QF_BV");
  const Line a = any_line(p, script);
  script.assume((a.holds & is_set(a.state.formed)).expression());
  const auto out = next(p, a.state, pins_at_rest()).outputs;
  const BitVector before = shift_left(a.words, p.gamma());
  Truth wrong = !is_set(out.strobe);
  for (int q = 1; q <= p.word(); ++q) {
    const BitVector position = before + BitVector(q);
    const Truth in_line = !(position > a.bp);
    const Truth steps = in_line & belongs(p, a.code, position);
    wrong = wrong | differ(bit(out.major, p.word() - q), in_line) |
            differ(bit(out.minor, p.word() - q), steps);
  }
  return {script, wrong};
}

// A clock: the next word is formed after this one, or the line ends with no position left.
Asked words_follow(const Widths& widths) {
  const Params p = params(widths);
  Script script("QF_BV");
  const Line a = any_line(p, script);
  script.assume(a.holds.expression());
  const State<BitVector> next = linear::next(p, a.state, pins_at_rest()).state;
  const BitVector words = a.words + a.state.formed;
  const State<BitVector> wanted = on_its_way(p, a.bp, words, a.code, BitVector(1), next.last_bit);
  const Truth some_left = wanted.left > BitVector(0);
  const Truth goes_on = some_left & same(next, wanted) & formed_right(p, next);
  const Truth ends = same(next, at_rest(a.state)) & !some_left;
  return {script, !(goes_on | ends)};
}

}  // namespace

std::vector<proof::Theorem> word_theorems() {
  const auto theorem = [](const char* sentence, Asked (*ask)(const Widths&)) {
    return at_every_width(Design::name, sentence, ask);
  };
  return {
      theorem("at every shipped width BP and UK written and a start put a machine at rest before "
              "the first of BP positions; a line of none ends there, with no word",
              line_begins),
      theorem("at every shipped width, position q of the word after T words is position "
              "T 2^gamma + q of the line: major steps there if that is at most BP, and "
              "minor if moreover its bit of the code is set",
              words_hold),
      theorem("at every shipped width word follows word on every clock until no position is "
              "left, and then the machine is at rest: so major gets BP steps",
              words_follow)};
}

}  // namespace cosim::linear
