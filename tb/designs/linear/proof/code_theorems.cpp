// SU 1631518: what a code gives, for every BP of up to 32 bits. Position q >= 1 of a line belongs
// to bit i of the code, a_i, where q = 2^(i-1) * odd.
#include <fmt/core.h>

#include "tb/designs/linear/proof/theorems.h"
#include "tb/proof/bits.h"

namespace cosim::linear {
namespace {

using namespace proof;

constexpr int kMostBits = 32;

// A sentence for every i from 1 to 32, each a question, on numbers of up to 32 bits.
class ForEveryBit {
 public:
  BitVector number(const std::string& name) {
    return BitVector::unsigned_code(script_.declare(name, bit_vector(kMostBits)), kMostBits);
  }
  void assume(const Truth& t) { script_.assume(t.expression()); }
  void ask(int i, const Truth& t) {
    Script script = script_;
    script.ask(negation(t.expression()));
    negated_.push_back({fmt::format("i = {}", i), script.text()});
  }
  Theorem theorem(const std::string& sentence) {
    Script premises = script_;
    premises.ask(truth(true));
    return {"linear", sentence, negated_, {{"any i", premises.text()}}};
  }

 private:
  Script script_{"QF_BV"};
  std::vector<ScriptOf> negated_;
};

// B_i = floor((BP + 2^(i-1)) / 2^i): what a_i weighs in a line of BP positions.
BitVector weight(const BitVector& bp, int i) {
  return shift_right(bp + BitVector(cosim::shift_left(1, i - 1)), i);
}

Theorem weights_count() {
  ForEveryBit a;
  const BitVector q = a.number("q");
  a.assume(q > BitVector(0));
  for (int i = 1; i <= kMostBits; ++i) {
    const Truth is_here = low_bits(q, i) == BitVector(cosim::shift_left(1, i - 1));
    const BitVector more = select(is_here, BitVector(1), BitVector(0));
    a.ask(i, (weight(q, i) == weight(q - BitVector(1), i) + more) &
                 (weight(BitVector(0), i) == BitVector(0)));
  }
  return a.theorem(
      "of the positions 1..BP exactly B_i belong to a_i, by induction over BP < 2^32: so a line "
      "gets the sum of a_i B_i minor steps");
}

Theorem weights_sum() {
  ForEveryBit a;
  const BitVector bp = a.number("BP");
  for (int i = 1; i <= kMostBits; ++i) {
    const Truth some_left = shift_right(bp, i) > BitVector(0);
    a.ask(i, (shift_right(bp, i - 1) == weight(bp, i) + shift_right(bp, i)) &
                 !(some_left & (bp < BitVector(cosim::shift_left(1, i)))));
  }
  return a.theorem(
      "the sum of B_1..B_i is BP - floor(BP / 2^i), which for i = m is BP, for every BP < 2^m");
}

Theorem codes() {
  ForEveryBit a;
  const BitVector bp = a.number("BP"), rest = a.number("rest");
  for (int i = 1; i <= kMostBits; ++i) {
    const BitVector b = weight(bp, i);
    const BitVector less = select(rest < b, rest, rest - b);
    const Truth too_much = rest > shift_right(bp, i - 1);
    a.ask(i, too_much | !((less < BitVector(0)) | (less > shift_right(bp, i))));
  }
  return a.theorem(
      "every MP in 0..BP has a code: taking B_i wherever it fits leaves at most floor(BP / 2^i), "
      "which for i = m is nothing");
}

}  // namespace

std::vector<proof::Theorem> code_theorems() { return {weights_count(), weights_sum(), codes()}; }

}  // namespace cosim::linear
