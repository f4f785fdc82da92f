// SU 1631518: what a code gives, for every BP of up to 32 bits. Position q >= 1 of a line belongs
// to bit i of the code, a_i, where q = 2^(i-1) * odd.
#include <fmt/core.h>

#include "tb/designs/linear/proof/theorems.h"

namespace cosim::linear {
namespace {

using namespace proof;
using nets::Number, nets::Truth;

constexpr int kMostBits = 32;

// A sentence for every i from 1 to 32, each a question, on numbers of up to 32 bits.
class ForEveryBit {
 public:
  Number number(const std::string& name) { return free_.number(name, kMostBits); }
  void assume(const Truth& t) { free_.assume(t); }
  void ask(int i, const Truth& t) { all_.push_back(free_.asked(fmt::format("i = {}", i), !t)); }
  Theorem theorem(const std::string& sentence) { return {"linear", sentence, {}, all_}; }

 private:
  FreeNumbers free_;
  std::vector<OnBits> all_;
};

// B_i = floor((BP + 2^(i-1)) / 2^i): what a_i weighs in a line of BP positions.
Number weight(const Number& bp, int i) {
  return shift_right(bp + Number(cosim::shift_left(1, i - 1)), i);
}

Theorem weights_count() {
  ForEveryBit a;
  const Number q = a.number("q");
  a.assume(q > Number(0));
  for (int i = 1; i <= kMostBits; ++i) {
    const Truth is_here = low_bits(q, i) == Number(cosim::shift_left(1, i - 1));
    const Number more = select(is_here, Number(1), Number(0));
    a.ask(i,
          (weight(q, i) == weight(q - Number(1), i) + more) & (weight(Number(0), i) == Number(0)));
  }
  return a.theorem(
      "of the positions 1..BP exactly B_i belong to a_i, by induction over BP < 2^32: so a line "
      "gets the sum of a_i B_i minor steps");
}

Theorem weights_sum() {
  ForEveryBit a;
  const Number bp = a.number("BP");
  for (int i = 1; i <= kMostBits; ++i) {
    const Truth some_left = shift_right(bp, i) > Number(0);
    a.ask(i, (shift_right(bp, i - 1) == weight(bp, i) + shift_right(bp, i)) &
                 !(some_left & (bp < Number(cosim::shift_left(1, i)))));
  }
  return a.theorem(
      "the sum of B_1..B_i is BP - floor(BP / 2^i), which for i = m is BP, for every BP < 2^m");
}

Theorem codes() {
  ForEveryBit a;
  const Number bp = a.number("BP"), rest = a.number("rest");
  for (int i = 1; i <= kMostBits; ++i) {
    const Number b = weight(bp, i);
    const Number less = select(rest < b, rest, rest - b);
    const Truth too_much = rest > shift_right(bp, i - 1);
    a.ask(i, too_much | !((less < Number(0)) | (less > shift_right(bp, i))));
  }
  return a.theorem(
      "every MP in 0..BP has a code: taking B_i wherever it fits leaves at most floor(BP / 2^i), "
      "which for i = m is nothing");
}

}  // namespace

std::vector<proof::Theorem> code_theorems() { return {weights_count(), weights_sum(), codes()}; }

}  // namespace cosim::linear
