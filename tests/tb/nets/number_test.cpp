// A model gives as gates what it gives on words: the gates are run on the bits of the words.
#include "tb/nets/number.h"

#include <gtest/gtest.h>

#include <array>

#include "tb/nets/runs.h"
#include "tb/util/random.h"
#include "tests/support/operations.h"

namespace cosim::nets {
namespace {

const auto operations = test::operations<Number>;

// Free numbers x and y of some bits, each with a sign or without, of one graph.
struct Free {
  Graph graph;
  Number x, y;
  int width;
  Free(int bits, bool x_signed, bool y_signed) : width(bits) {
    const auto code = [&] {
      std::vector<Bit> all;
      for (int i = 0; i < bits; ++i) all.push_back(graph.input());
      return all;
    };
    const auto number = [&](bool is_signed) {
      return is_signed ? Number::signed_code(graph, code()) : Number::unsigned_code(graph, code());
    };
    x = number(x_signed);
    y = number(y_signed);
  }
};

// The words that a number is in 64 runs, in which x and y have these codes.
std::array<Word, 64> in_runs_of(const Free& free, const Number& number,
                                const std::array<Word, 64>& x, const std::array<Word, 64>& y) {
  std::vector<std::uint64_t> inputs;
  for (const auto* codes : {&x, &y}) {
    for (int i = 0; i < free.width; ++i) {
      inputs.push_back(0);
      for (std::size_t r = 0; r < 64; ++r) {
        inputs.back() |= std::uint64_t{cosim::bit((*codes)[r], i)} << r;
      }
    }
  }
  const auto gates = run(free.graph, inputs);
  std::array<Word, 64> words{};
  for (int i = 0; i < 64; ++i) {
    const std::uint64_t plane = in_runs(gates, number.at(i));
    for (std::size_t r = 0; r < 64; ++r) {
      words[r] |= cosim::shift_left(static_cast<Word>(plane >> r & 1), i);
    }
  }
  return words;
}

// The words of 64 codes, and the numbers' of an operation, are the same.
void expect_same(const test::Operation<Number>& o, const std::array<Word, 64>& x,
                 const std::array<Word, 64>& y, int width) {
  for (const bool x_signed : {false, true}) {
    for (const bool y_signed : {false, true}) {
      Free free(width, x_signed, y_signed);
      const auto words = in_runs_of(free, o.on_values(free.x, free.y), x, y);
      for (std::size_t r = 0; r < 64; ++r) {
        const Word a = x_signed ? from_twos_complement(x[r], width) : x[r];
        const Word b = y_signed ? from_twos_complement(y[r], width) : y[r];
        ASSERT_EQ(words[r], o.on_words(a, b)) << o.name << " of " << a << " and " << b;
      }
    }
  }
}

TEST(Number, OfKnownValuesIsKnown) {
  Random random(7);
  for (const auto& o : operations()) {
    for (int i = 0; i < 1000; ++i) {
      const Word a = from_twos_complement(random.corner(9), 9),
                 b = from_twos_complement(random.corner(9), 9);
      EXPECT_EQ(o.on_values(Number(a), Number(b)).known(), o.on_words(a, b))
          << o.name << ' ' << a << ' ' << b;
    }
  }
}

// One of the two known, as constants in a model are.
TEST(Number, OfAKnownValueAndAFreeOneIsWhatWordsAre) {
  Random random(9);
  for (const auto& o : operations()) {
    for (int i = 0; i < 5; ++i) {
      const Word known = from_twos_complement(random.corner(9), 9);
      std::array<Word, 64> x{}, y{};
      for (Word& code : x) code = random.corner(9);
      Free free(9, true, true);
      const auto left = in_runs_of(free, o.on_values(free.x, Number(known)), x, y);
      const auto right = in_runs_of(free, o.on_values(Number(known), free.x), x, y);
      for (std::size_t r = 0; r < 64; ++r) {
        const Word a = from_twos_complement(x[r], 9);
        ASSERT_EQ(left[r], o.on_words(a, known)) << o.name << " of " << a << " and " << known;
        ASSERT_EQ(right[r], o.on_words(known, a)) << o.name << " of " << known << " and " << a;
      }
    }
  }
}

TEST(Number, OfFreeBitsIsWhatWordsAre) {
  Random random(8);
  for (const auto& o : operations()) {
    for (int i = 0; i < 4; ++i) {
      std::array<Word, 64> x{}, y{};
      for (Word& code : x) code = random.corner(9);
      for (Word& code : y) code = random.corner(9);
      expect_same(o, x, y, 9);
    }
  }
}

TEST(Number, OfThreeBitsIsWhatWordsAreForAllValues) {
  std::array<Word, 64> x{}, y{};
  for (std::size_t r = 0; r < 64; ++r) {
    x[r] = static_cast<Word>(r & 7);
    y[r] = static_cast<Word>(r >> 3);
  }
  for (const auto& o : operations()) expect_same(o, x, y, 3);
}

// No more bits than its gates can make differ.
TEST(Number, HasNoMoreBitsThanItNeeds) {
  Free free(9, false, true);
  EXPECT_EQ(free.x.width(), 10);
  EXPECT_EQ(free.y.width(), 9);
  EXPECT_EQ((free.x + free.y).width(), 11);
  EXPECT_EQ(low_bits(free.x, 20).width(), 10);
  EXPECT_EQ(shift_right(free.x, 9).known(), 0);
  EXPECT_EQ(Number(-1).width(), 1);
}

// How many gates a number comes to.
std::size_t gates_of(const Graph& graph, const Number& number) {
  std::vector<bool> needed(graph.gates().size());
  for (const Bit bit : number.code(number.width())) needed[bit.gate()] = true;
  std::size_t count = 0;
  for (std::size_t i = needed.size(); i-- > 0;) {
    const Graph::Made& g = graph.gates()[i];
    if (!needed[i] || g.kind == Gate::constant || g.kind == Gate::input) continue;
    ++count;
    for (const Bit bit : {g.a, g.b, g.c}) needed[bit.gate()] = true;
  }
  return count;
}

// The carry of the negation is that of the sum.
TEST(Number, ThatWasNegatedIsAddedLikeAnyOther) {
  Free free(9, true, true);
  const Truth turns = bit(free.y, 0);
  const auto plain = gates_of(free.graph, free.x + select(turns, Number(-1) - free.y, free.y));
  EXPECT_LE(gates_of(free.graph, free.x + select(turns, Number(0) - free.y, free.y)), plain + 3);
  EXPECT_EQ(gates_of(free.graph, free.x + (Number(0) - free.y)),
            gates_of(free.graph, free.x - free.y));
}

}  // namespace
}  // namespace cosim::nets
