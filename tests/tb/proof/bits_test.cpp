// A model gives on symbols what it gives on words: for known values the formulas are known, and for
// symbols a solver must find no value for which they differ.
#include "tb/proof/bits.h"

#include <gtest/gtest.h>

#include <functional>

#include "tb/proof/solver.h"
#include "tb/support/process.h"
#include "tb/support/random.h"

namespace cosim {
namespace {

// Several operations at once.
template <class V>
V wrapped(const V& v) {
  return select(v > V(255), v - V(511), select(v < V(-255), v + V(511), v));
}
template <class V>
V exchanged(const V& v) {
  return shift_left(both(v, V(0xf)), 4) + both(shift_right(v, 4), V(0xf));
}

}  // namespace
}  // namespace cosim

namespace cosim::proof {
namespace {

using WordOperation = std::function<Word(Word, Word)>;
using BitsOperation = std::function<Bits(const Bits&, const Bits&)>;
struct Operation {
  const char* name;
  WordOperation on_words;
  BitsOperation on_bits;
};

// Every operation that a model may use, with widths and shifts of several kinds.
std::vector<Operation> operations() {
  return {
      {"+", [](Word a, Word b) { return a + b; },
       [](const Bits& a, const Bits& b) { return a + b; }},
      {"-", [](Word a, Word b) { return a - b; },
       [](const Bits& a, const Bits& b) { return a - b; }},
      {"a + a", [](Word a, Word) { return a + a; },
       [](const Bits& a, const Bits&) { return a + a; }},
      {"8 a + low bits of b",
       [](Word a, Word b) { return cosim::shift_left(a, 3) + cosim::low_bits(b, 3); },
       [](const Bits& a, const Bits& b) { return shift_left(a, 3) + low_bits(b, 3); }},
      {"<", [](Word a, Word b) { return Word{a < b}; },
       [](const Bits& a, const Bits& b) { return select(a < b, Bits(1), Bits(0)); }},
      {">", [](Word a, Word b) { return Word{a > b}; },
       [](const Bits& a, const Bits& b) { return select(a > b, Bits(1), Bits(0)); }},
      {"==", [](Word a, Word b) { return Word{a == b}; },
       [](const Bits& a, const Bits& b) { return select(a == b, Bits(1), Bits(0)); }},
      {"low_bits", [](Word a, Word) { return cosim::low_bits(a, 5); },
       [](const Bits& a, const Bits&) { return low_bits(a, 5); }},
      {"low_bits of few", [](Word a, Word) { return cosim::low_bits(a, 40); },
       [](const Bits& a, const Bits&) { return low_bits(a, 40); }},
      {"bit", [](Word a, Word) { return Word{cosim::bit(a, 3)}; },
       [](const Bits& a, const Bits&) { return select(bit(a, 3), Bits(1), Bits(0)); }},
      {"bit beyond", [](Word a, Word) { return Word{cosim::bit(a, 50)}; },
       [](const Bits& a, const Bits&) { return select(bit(a, 50), Bits(1), Bits(0)); }},
      {"shift_left", [](Word a, Word) { return cosim::shift_left(a, 7); },
       [](const Bits& a, const Bits&) { return shift_left(a, 7); }},
      {"shift_right", [](Word a, Word) { return cosim::shift_right(a, 4); },
       [](const Bits& a, const Bits&) { return shift_right(a, 4); }},
      {"shift_right of all", [](Word a, Word) { return cosim::shift_right(a, 30); },
       [](const Bits& a, const Bits&) { return shift_right(a, 30); }},
      {"both", [](Word a, Word b) { return cosim::both(a, b); },
       [](const Bits& a, const Bits& b) { return both(a, b); }},
      {"a sum that wraps", [](Word a, Word b) { return wrapped(a + b); },
       [](const Bits& a, const Bits& b) { return wrapped(a + b); }},
      {"halves exchanged", [](Word a, Word) { return exchanged(a); },
       [](const Bits& a, const Bits&) { return exchanged(a); }},
      {"not, and, or", [](Word a, Word b) { return Word{!(a < 0 && b > 3) || a == b}; },
       [](const Bits& a, const Bits& b) {
         return select((a == b) | !((a < Bits(0)) & (b > Bits(3))), Bits(1), Bits(0));
       }},
  };
}

TEST(Bits, OfKnownValuesAreKnown) {
  Random random(7);
  for (const Operation& o : operations()) {
    for (int i = 0; i < 1000; ++i) {
      const Word a = from_twos_complement(random.corner(9), 9),
                 b = from_twos_complement(random.corner(9), 9);
      const Bits result = o.on_bits(Bits(a), Bits(b));
      const Expression code = result.code(64);
      const Word expected = o.on_words(a, b);
      EXPECT_EQ(code.text(), Bits(expected).code(64).text()) << o.name << ' ' << a << ' ' << b;
    }
  }
}

// The formula on symbols, with the symbols then said to be a and b, can only be the word's result.
TEST(Bits, OfSymbolsAreWhatWordsAre) {
  if (run_program({"z3", "--version"}).status == 127) GTEST_SKIP() << "needs z3";
  Random random(8);
  Script script("QF_BV");
  std::size_t asked = 0;
  const Expression x = script.declare("x", bit_vector(9)), y = script.declare("y", bit_vector(9));
  const auto both_ways = {std::pair{Bits::signed_code(x, 9), Bits::unsigned_code(y, 9)},
                          std::pair{Bits::unsigned_code(x, 9), Bits::signed_code(y, 9)}};
  for (const Operation& o : operations()) {
    bool x_signed = true;
    for (const auto& [a, b] : both_ways) {
      const Bits result = o.on_bits(a, b);
      for (int i = 0; i < 20; ++i) {
        const Word code_x = random.corner(9), code_y = random.corner(9);
        const Word u = x_signed ? from_twos_complement(code_x, 9) : code_x;
        const Word v = x_signed ? code_y : from_twos_complement(code_y, 9);
        const Word expected = o.on_words(u, v);
        ASSERT_LE(result.least(), expected) << o.name;
        ASSERT_GE(result.most(), expected) << o.name;
        const Expression wrong = negation(equal(result.code(64), Bits(expected).code(64)));
        const Expression here =
            conjunction(equal(x, Bits(code_x).code(9)), equal(y, Bits(code_y).code(9)));
        script.ask_apart(conjunction(here, wrong));
        ++asked;
      }
      x_signed = false;
    }
  }
  const Solved solved = solve(solvers()[1], script.text(), 60);
  ASSERT_EQ(solved.answers.size(), asked) << solved.said;
  for (std::size_t i = 0; i < asked; ++i) {
    EXPECT_EQ(solved.answers[i], Answer::unsat) << operations()[i / 40].name;
  }
}

}  // namespace
}  // namespace cosim::proof
