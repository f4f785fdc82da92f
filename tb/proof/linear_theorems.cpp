// SU 1631518: what a code gives, for every BP of up to 32 bits, and what the words hold, at every
// width that is shipped. Position q >= 1 of a line belongs to bit i of the code, a_i, where q =
// 2^(i-1) * odd.
#include <fmt/format.h>

#include "model/linear/machine.h"
#include "tb/proof/machines.h"
#include "tb/proof/theorems.h"

namespace cosim::proof {
namespace {

using linear::Inputs;
using linear::Params;
using linear::State;

constexpr int kMostBits = 32;

// A sentence for every i from 1 to 32, each a question, on numbers of up to 32 bits.
class ForEveryBit {
 public:
  Bits number(const std::string& name) {
    return Bits::unsigned_code(script_.declare(name, bit_vector(kMostBits)), kMostBits);
  }
  void assume(const Truth& t) { script_.assume(t.expression()); }
  void ask(int i, const Truth& t) {
    Script script = script_;
    script.ask(negation(t.expression()));
    queries_.push_back({{fmt::format("i = {}", i)}, script.text()});
  }
  Theorem theorem(const std::string& sentence) {
    Script premises = script_;
    premises.ask(truth(true));
    return {"linear",
            sentence,
            {sentence, Answer::unsat, queries_, {}},
            {"its premises", Answer::sat, {{{"any i"}, premises.text()}}, {}}};
  }

 private:
  Script script_{"QF_BV"};
  std::vector<Query> queries_;
};

// B_i = floor((BP + 2^(i-1)) / 2^i): what a_i weighs in a line of BP positions.
Bits weight(const Bits& bp, int i) {
  return shift_right(bp + Bits(cosim::shift_left(1, i - 1)), i);
}

Theorem weights_count() {
  ForEveryBit a;
  const Bits q = a.number("q");
  a.assume(q > Bits(0));
  for (int i = 1; i <= kMostBits; ++i) {
    const Truth is_here = low_bits(q, i) == Bits(cosim::shift_left(1, i - 1));
    const Bits more = select(is_here, Bits(1), Bits(0));
    a.ask(i, (weight(q, i) == weight(q - Bits(1), i) + more) & (weight(Bits(0), i) == Bits(0)));
  }
  return a.theorem(
      "of the positions 1..BP exactly B_i belong to a_i, by induction over BP < 2^32: so a line "
      "gets the sum of a_i B_i minor steps");
}

Theorem weights_sum() {
  ForEveryBit a;
  const Bits bp = a.number("BP");
  for (int i = 1; i <= kMostBits; ++i) {
    const Truth some_left = shift_right(bp, i) > Bits(0);
    a.ask(i, (shift_right(bp, i - 1) == weight(bp, i) + shift_right(bp, i)) &
                 !(some_left & (bp < Bits(cosim::shift_left(1, i)))));
  }
  return a.theorem(
      "the sum of B_1..B_i is BP - floor(BP / 2^i), which for i = m is BP, for every BP < 2^m");
}

Theorem codes() {
  ForEveryBit a;
  const Bits bp = a.number("BP"), rest = a.number("rest");
  for (int i = 1; i <= kMostBits; ++i) {
    const Bits b = weight(bp, i);
    const Bits less = select(rest < b, rest, rest - b);
    const Truth too_much = rest > shift_right(bp, i - 1);
    a.ask(i, too_much | !((less < Bits(0)) | (less > shift_right(bp, i))));
  }
  return a.theorem(
      "every MP in 0..BP has a code: taking B_i wherever it fits leaves at most floor(BP / 2^i), "
      "which for i = m is nothing");
}

// A line on its way: T words are put out of BP positions, the code is C.
struct OnTheWay {
  Bits bp, words, code;
  State<Bits> state;
  Truth holds = true;
};

Truth formed_right(const Params& p, const State<Bits>& s) {
  return (s.last_bit == linear::last_bit_of(p, s.low_code, s.tick)) | !is_set(s.formed);
}

OnTheWay on_the_way(const Params& p, Script& script) {
  const auto symbol = [&](const char* name, int width) {
    return Bits::unsigned_code(script.declare(name, bit_vector(width)), width);
  };
  OnTheWay a;
  a.bp = symbol("BP", p.m);
  a.words = symbol("T", p.n + 1);
  a.code = symbol("C", p.m);
  a.state.running = a.state.coded = Bits(1);
  a.state.formed = symbol("formed", 1);
  a.state.left = a.bp - shift_left(a.words, p.gamma());
  a.state.tick = low_bits(a.words + a.state.formed, p.n);
  a.state.low_code = low_bits(a.code, p.n);
  a.state.pattern = linear::pattern_of(p, a.code);
  a.state.last_bit = symbol("last_bit", 1);
  // Before the first word none is put out; behind that each has positions.
  a.holds = (a.state.left > Bits(0)) & ((a.words == Bits(0)) | is_set(a.state.formed)) &
            formed_right(p, a.state);
  return a;
}

Inputs<Bits> at_rest() {
  Inputs<Bits> in;
  in.initial_set_n = Bits(1);
  return in;
}

// Whether minor steps at position q: the bit of the code that it belongs to.
Truth belongs(const Params& p, const Bits& code, const Bits& q) {
  Truth any = false;
  for (int i = 1; i <= p.m; ++i) {
    const Truth here = low_bits(q, i) == Bits(cosim::shift_left(1, i - 1));
    any = any | (here & bit(code, p.m - i));
  }
  return any;
}

Truth differ(const Truth& a, const Truth& b) { return (a & !b) | (b & !a); }

// What is assumed, and what must not be.
struct Asked {
  Script script;
  Truth wrong;
};

// At one width. The strobe is up: the words hold positions T 2^gamma + 1 and on.
Asked words_hold(const Params& p) {
  Script script("QF_BV");
  const OnTheWay a = on_the_way(p, script);
  script.assume((a.holds & is_set(a.state.formed)).expression());
  const auto out = linear::next(p, a.state, at_rest()).outputs;
  const Bits before = shift_left(a.words, p.gamma());
  Truth wrong = !is_set(out.strobe);
  for (int q = 1; q <= p.word(); ++q) {
    const Bits position = before + Bits(q);
    const Truth in_line = !(position > a.bp);
    const Truth steps = in_line & belongs(p, a.code, position);
    wrong = wrong | differ(bit(out.major, p.word() - q), in_line) |
            differ(bit(out.minor, p.word() - q), steps);
  }
  return {script, wrong};
}

// A clock: the next word is formed after this one, or the line ends with no position left.
Asked words_follow(const Params& p) {
  Script script("QF_BV");
  const OnTheWay a = on_the_way(p, script);
  script.assume(a.holds.expression());
  const State<Bits> next = linear::next(p, a.state, at_rest()).state;
  const Bits words = a.words + a.state.formed;
  const Bits left = a.bp - shift_left(words, p.gamma());
  const Truth goes_on = is_set(next.running) & is_set(next.formed) & (next.left == left) &
                        (next.left > Bits(0)) & (next.tick == low_bits(words + Bits(1), p.n)) &
                        formed_right(p, next) & (next.low_code == a.state.low_code) &
                        (next.pattern == a.state.pattern);
  const Truth ends = (next.running == Bits(0)) & (next.formed == Bits(0)) & !(left > Bits(0));
  return {script, !(goes_on | ends)};
}

Theorem for_every_width(const std::string& sentence, Asked (*ask)(const Params&)) {
  Claim claim{sentence, Answer::unsat, {}, {}}, premises{"its premises", Answer::sat, {}, {}};
  for (const auto& machine : built_machines()) {
    const MachineFormula formula = machine.formula();
    if (formula.design != linear::Design::name) continue;
    auto [script, wrong] = ask({formula.parameters[0].value, formula.parameters[1].value});
    Script possible = script;
    possible.ask(truth(true));
    premises.queries.push_back({{machine.title}, possible.text(), true});
    script.ask(wrong.expression());
    claim.queries.push_back({{machine.title}, script.text(), true});
  }
  return {"linear", sentence, claim, premises};
}

}  // namespace

std::vector<Theorem> linear_theorems() {
  return {
      weights_count(), weights_sum(), codes(),
      for_every_width("at every shipped width, position q of the word after T words is position "
                      "T 2^gamma + q of the line: major steps there if that is at most BP, and "
                      "minor if moreover its bit of the code is set",
                      words_hold),
      for_every_width("at every shipped width word follows word on every clock until no "
                      "position is left, and then the line ends: so major gets BP steps",
                      words_follow)};
}

}  // namespace cosim::proof
