// A model gives on symbols what it gives on words: for known values the formulas are known, and for
// symbols a solver must find no value for which they differ.
#include "tb/proof/bits.h"

#include <gtest/gtest.h>

#include <functional>

#include "model/core/bit_strings.h"
#include "model/core/memory.h"
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
  return shift_left(v & V(0xf), 4) + (shift_right(v, 4) & V(0xf));
}
// An array of five at an index of three bits and more: three of its elements are not there.
template <class V>
Array<V, 5> five(const V& a, const V& b) {
  return {{a, b, a + b, V(7), a - b}};
}
template <class V>
V read_five(const V& a, const V& b) {
  return read(five(a, b), b);
}
template <class V>
V write_five(const V& a, const V& b) {
  const auto written = write_where(a < V(3), write(five(a, b), b, V(11)), a, b);
  V sum(0);
  for (const V& e : written) sum = shift_left(sum, 2) + e;
  return sum;
}

using WordOperation = std::function<Word(Word, Word)>;
using proof::Bits;
using BitsOperation = std::function<Bits(const Bits&, const Bits&)>;
struct Operation {
  const char* name;
  WordOperation on_words;
  BitsOperation on_bits;
};

// Of one body for any value type.
template <class Text>
Operation of(const char* name, Text body) {
  return {name, [body](Word a, Word b) { return body(a, b); },
          [body](const Bits& a, const Bits& b) { return body(a, b); }};
}
// Every operation that a model may use, with widths and shifts of several kinds.
std::vector<Operation> operations() {
#define OF(name, text) \
  of(name, []<class V>(const V& a, [[maybe_unused]] const V& b) -> V { return text; })
#define HOLDS(name, text) OF(name, flag<V>(static_cast<Condition<V>>(text)))
  return {
      OF("+", a + b),
      OF("-", a - b),
      OF("a + a", a + a),
      OF("8 a + low bits of b", shift_left(a, 3) + low_bits(b, 3)),
      OF("*", a * b),
      OF("* of a negative constant", a * V(-3)),
      OF("* beyond a word", multiply(multiply(a, V(Word{1} << 60)), b)),
      OF("+ beyond a word", add(shift_left(a, 60), shift_left(b, 60))),
      OF("- beyond a word", subtract(shift_left(a, 60), shift_left(b, 60))),
      OF("&", a & b),
      OF("|", a | b),
      OF("^", a ^ b),
      OF("& | ^ with constants", ((a & V(5)) | V(2)) ^ V(-4)),
      HOLDS("<", a < b),
      HOLDS(">", a > b),
      HOLDS("==", a == b),
      HOLDS("below", below(a, b)),
      OF("low_bits", low_bits(a, 5)),
      OF("low_bits of few", low_bits(a, 40)),
      HOLDS("bit", bit(a, 3)),
      HOLDS("bit beyond", bit(a, 50)),
      OF("shift_left", shift_left(a, 7)),
      OF("shift_right", shift_right(a, 4)),
      OF("shift_right of all", shift_right(a, 30)),
      OF("shift_left by a value", shift_left(a, b)),
      OF("shift_left by few", shift_left(a, b & V(7))),
      OF("shift_left by many", shift_left(a, shift_left(b, 3))),
      OF("shift_right by a value", shift_right(a, b)),
      OF("shift_right by many", shift_right(a, shift_left(b, 3))),
      OF("slice", slice(a, 6, 2)),
      OF("join", join(a, b, 3)),
      OF("invert", invert(a, 6)),
      OF("rotate_left", rotate_left(a, 2, 5)),
      HOLDS("all_set", all_set(a, 3)),
      HOLDS("parity", parity(a, 7)),
      OF("read", read_five(a, b)),
      OF("write", write_five(a, b)),
      OF("a sum that wraps", wrapped(a + b)),
      OF("halves exchanged", exchanged(a)),
      HOLDS("not, and, or", (a == b) | !((a < V(0)) & (b > V(3)))),
      HOLDS("not of one, exclusive or", !(a == b) & ((a < V(0)) ^ (b > V(3)))),
  };
#undef HOLDS
#undef OF
}

}  // namespace

namespace proof {
namespace {

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

// For all values of three bits, each with a sign and without: no pair for which the formula is not
// what the words give.
TEST(Bits, OfThreeBitsAreWhatWordsAreForAllValues) {
  if (run_program({"z3", "--version"}).status == 127) GTEST_SKIP() << "needs z3";
  constexpr int width = 3;
  Script script("QF_BV");
  const Expression x = script.declare("x", bit_vector(width)),
                   y = script.declare("y", bit_vector(width));
  const auto value = [](Word code, bool is_signed) {
    return is_signed ? from_twos_complement(code, width) : code;
  };
  const auto bits = [](const Expression& e, bool is_signed) {
    return is_signed ? Bits::signed_code(e, width) : Bits::unsigned_code(e, width);
  };
  std::vector<const char*> asked;
  const std::vector<Operation> all = operations();
  for (const Operation& o : all) {
    for (const bool x_signed : {false, true}) {
      for (const bool y_signed : {false, true}) {
        const Expression result = o.on_bits(bits(x, x_signed), bits(y, y_signed)).code(64);
        std::vector<Expression> wrong;
        for (Word a = 0; a <= ones(width); ++a) {
          for (Word b = 0; b <= ones(width); ++b) {
            const Word expected = o.on_words(value(a, x_signed), value(b, y_signed));
            wrong.emplace_back(
                "and", boolean,
                std::vector{equal(x, Bits(a).code(width)), equal(y, Bits(b).code(width)),
                            negation(equal(result, Bits(expected).code(64)))});
          }
        }
        script.ask_apart(Expression("or", boolean, wrong));
        asked.push_back(o.name);
      }
    }
  }
  const Solved solved = solve(solvers()[1], script.text(), 120);
  ASSERT_EQ(solved.answers.size(), asked.size()) << solved.said;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    EXPECT_EQ(solved.answers[i], Answer::unsat) << asked[i];
  }
}

}  // namespace
}  // namespace proof
}  // namespace cosim
