// A model gives on symbols what it gives on words: for known values the formulas are known, and for
// symbols a solver must find no value for which they differ.
#include "tb/proof/bits.h"

#include <gtest/gtest.h>

#include "tb/proof/z3.h"
#include "tb/util/process.h"
#include "tb/util/random.h"
#include "tests/support/operations.h"

namespace cosim::proof {
namespace {

using Operation = test::Operation<BitVector>;
const auto operations = test::operations<BitVector>;

TEST(BitVector, OfKnownValuesAreKnown) {
  Random random(7);
  for (const Operation& o : operations()) {
    for (int i = 0; i < 1000; ++i) {
      const Word a = from_twos_complement(random.corner(9), 9),
                 b = from_twos_complement(random.corner(9), 9);
      const BitVector result = o.on_values(BitVector(a), BitVector(b));
      const Expression code = result.code(64);
      const Word expected = o.on_words(a, b);
      EXPECT_EQ(code.text(), BitVector(expected).code(64).text()) << o.name << ' ' << a << ' ' << b;
    }
  }
}

// The formula on symbols, with the symbols then said to be a and b, can only be the word's result.
TEST(BitVector, OfSymbolsAreWhatWordsAre) {
  if (run_program({"z3", "--version"}).status == 127) GTEST_SKIP() << "needs z3";
  Random random(8);
  Script script("QF_BV");
  std::size_t asked = 0;
  const Expression x = script.declare("x", bit_vector(9)), y = script.declare("y", bit_vector(9));
  const auto both_ways = {std::pair{BitVector::signed_code(x, 9), BitVector::unsigned_code(y, 9)},
                          std::pair{BitVector::unsigned_code(x, 9), BitVector::signed_code(y, 9)}};
  for (const Operation& o : operations()) {
    bool x_signed = true;
    for (const auto& [a, b] : both_ways) {
      const BitVector result = o.on_values(a, b);
      for (int i = 0; i < 20; ++i) {
        const Word code_x = random.corner(9), code_y = random.corner(9);
        const Word u = x_signed ? from_twos_complement(code_x, 9) : code_x;
        const Word v = x_signed ? code_y : from_twos_complement(code_y, 9);
        const Word expected = o.on_words(u, v);
        ASSERT_LE(result.least(), expected) << o.name;
        ASSERT_GE(result.most(), expected) << o.name;
        const Expression wrong = negation(equal(result.code(64), BitVector(expected).code(64)));
        const Expression here =
            conjunction(equal(x, BitVector(code_x).code(9)), equal(y, BitVector(code_y).code(9)));
        script.ask_apart(conjunction(here, wrong));
        ++asked;
      }
      x_signed = false;
    }
  }
  const Solved solved = solve_by_z3(script.text(), 60);
  ASSERT_EQ(solved.answers.size(), asked) << solved.said;
  for (std::size_t i = 0; i < asked; ++i) {
    EXPECT_EQ(solved.answers[i], Answer::unsat) << operations()[i / 40].name;
  }
}

// For all values of three bits, each with a sign and without: no pair for which the formula is not
// what the words give.
TEST(BitVector, OfThreeBitsAreWhatWordsAreForAllValues) {
  if (run_program({"z3", "--version"}).status == 127) GTEST_SKIP() << "needs z3";
  constexpr int width = 3;
  Script script("QF_BV");
  const Expression x = script.declare("x", bit_vector(width)),
                   y = script.declare("y", bit_vector(width));
  const auto value = [](Word code, bool is_signed) {
    return is_signed ? from_twos_complement(code, width) : code;
  };
  const auto bits = [](const Expression& e, bool is_signed) {
    return is_signed ? BitVector::signed_code(e, width) : BitVector::unsigned_code(e, width);
  };
  std::vector<const char*> asked;
  const std::vector<Operation> all = operations();
  for (const Operation& o : all) {
    for (const bool x_signed : {false, true}) {
      for (const bool y_signed : {false, true}) {
        const Expression result = o.on_values(bits(x, x_signed), bits(y, y_signed)).code(64);
        std::vector<Expression> wrong;
        for (Word a = 0; a <= ones(width); ++a) {
          for (Word b = 0; b <= ones(width); ++b) {
            const Word expected = o.on_words(value(a, x_signed), value(b, y_signed));
            wrong.emplace_back(
                "and", boolean,
                std::vector{equal(x, BitVector(a).code(width)), equal(y, BitVector(b).code(width)),
                            negation(equal(result, BitVector(expected).code(64)))});
          }
        }
        script.ask_apart(Expression("or", boolean, wrong));
        asked.push_back(o.name);
      }
    }
  }
  const Solved solved = solve_by_z3(script.text(), 120);
  ASSERT_EQ(solved.answers.size(), asked.size()) << solved.said;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    EXPECT_EQ(solved.answers[i], Answer::unsat) << asked[i];
  }
}

}  // namespace
}  // namespace cosim::proof
