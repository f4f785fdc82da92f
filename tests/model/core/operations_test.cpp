// The operations that a model may use beside sums and comparisons: on machine integers against
// their definitions tried out bit by bit, and on every other value type against machine integers.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "model/core/value.h"
#include "model/core/wide.h"
#include "tb/nets/number.h"
#include "tb/nets/runs.h"
#include "tb/util/random.h"
#include "tests/support/lanes.h"
#include "tests/support/strict.h"

namespace cosim {
namespace {

using test::each_lane, test::kLanes, test::Lanes, test::Strict;

// Bit i of v.
bool at(Word v, int i) { return ((static_cast<std::uint64_t>(v) >> i) & 1) != 0; }
// The word whose bit i is what `of` gives for i.
Word built(const std::function<bool(int)>& of) {
  std::uint64_t v = 0;
  for (int i = 0; i < 64; ++i) v |= static_cast<std::uint64_t>(of(i)) << i;
  return static_cast<Word>(v);
}

struct Pair {
  Word a, b;
};
// Words of any width, with and without a sign.
std::vector<Pair> pairs() {
  Random random(5);
  std::vector<Pair> all{{0, 0}, {-1, -1}, {-1, 63}, {-1, 64}, {1, -1}, {ones(63), -1}};
  for (int i = 0; i < 2000; ++i) {
    const auto any = [&] {
      const int width = 1 + static_cast<int>(random.below(64));
      const Word code = random.corner(width);
      return random.one_in_power(1) ? from_twos_complement(code, width) : code;
    };
    all.push_back({any(), any()});
  }
  return all;
}

TEST(Operations, AreBitByBit) {
  for (const Pair& pair : pairs()) {
    const Word a = pair.a, b = pair.b;
    ASSERT_EQ(a & b, built([&](int i) { return at(a, i) && at(b, i); }));
    ASSERT_EQ(a | b, built([&](int i) { return at(a, i) || at(b, i); }));
    ASSERT_EQ(a ^ b, built([&](int i) { return at(a, i) != at(b, i); }));
  }
}

TEST(Operations, ShiftByAValueAndLoseWhatIsOut) {
  for (const Pair& pair : pairs()) {
    const Word a = pair.a, b = pair.b;
    for (const Word n : {b, low_bits(b, 6), low_bits(b, 7)}) {
      const bool out = n < 0 || n > 63;
      ASSERT_EQ(shift_left(a, n),
                built([&](int i) { return !out && i >= n && at(a, i - static_cast<int>(n)); }))
          << a << " by " << n;
      ASSERT_EQ(shift_right(a, n), built([&](int i) {
                  return at(a, out || i + n > 63 ? 63 : i + static_cast<int>(n));
                }))
          << a << " by " << n;
    }
  }
}

TEST(Operations, Wrap) {
  for (const Pair& pair : pairs()) {
    const Word a = pair.a, b = pair.b;
    const auto modulo = [](Int128 n) { return static_cast<Word>(static_cast<std::uint64_t>(n)); };
    ASSERT_EQ(add(a, b), modulo(Int128{a} + b));
    ASSERT_EQ(subtract(a, b), modulo(Int128{a} - b));
    ASSERT_EQ(multiply(a, b), modulo(Int128{a} * b));
  }
}

// Each operation, of every value type: those that wrap or lose bits, and a product of few bits.
template <class V>
std::vector<V> results(const V& a, const V& b) {
  return {add(a, b),
          subtract(a, b),
          multiply(a, b),
          low_bits(a, 20) * low_bits(b, 30),
          a & b,
          a | b,
          a ^ b,
          shift_left(a, b),
          shift_right(a, b),
          shift_left(a, low_bits(b, 6)),
          shift_right(a, low_bits(b, 7))};
}

TEST(Operations, OfStrictValuesAreThoseOfWords) {
  for (const Pair& pair : pairs()) {
    const Word a = pair.a, b = pair.b;
    const auto expected = results<Word>(a, b);
    const auto strict = results<Strict>(Strict(a), Strict(b));
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(strict[i].word, expected[i]) << "operation " << i << " of " << a << " and " << b;
    }
  }
  EXPECT_THROW(Strict(ones(40)) * Strict(ones(40)), std::overflow_error);
}

TEST(Operations, OfLanesAreThoseOfWords) {
  const auto all = pairs();
  for (std::size_t first = 0; first + kLanes <= all.size(); first += kLanes) {
    const Lanes a(each_lane([&](std::size_t i) { return all[first + i].a; }));
    const Lanes b(each_lane([&](std::size_t i) { return all[first + i].b; }));
    const auto lanes = results<Lanes>(a, b);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const auto expected = results<Word>(a.lane[lane], b.lane[lane]);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(lanes[i].lane[lane], expected[i]) << "operation " << i;
      }
    }
  }
}

// As gates of two free numbers of 64 bits, run on 64 pairs at a time.
TEST(Operations, OfGatesAreThoseOfWords) {
  using nets::Bit, nets::Number;
  nets::Graph graph;
  const auto free_number = [&] {
    std::vector<Bit> code;
    for (int i = 0; i < 64; ++i) code.push_back(graph.input());
    return Number::signed_code(graph, code);
  };
  const Number x = free_number(), y = free_number();
  const auto numbers = results<Number>(x, y);
  const auto all = pairs();
  constexpr std::size_t runs = 64;
  for (std::size_t first = 0; first + runs <= all.size(); first += runs) {
    std::vector<std::uint64_t> inputs(128);
    for (std::size_t r = 0; r < runs; ++r) {
      for (std::size_t i = 0; i < 64; ++i) {
        inputs[i] |= std::uint64_t{at(all[first + r].a, static_cast<int>(i))} << r;
        inputs[64 + i] |= std::uint64_t{at(all[first + r].b, static_cast<int>(i))} << r;
      }
    }
    const auto gates = nets::run(graph, inputs);
    for (std::size_t r = 0; r < runs; ++r) {
      const auto expected = results<Word>(all[first + r].a, all[first + r].b);
      for (std::size_t o = 0; o < expected.size(); ++o) {
        ASSERT_EQ(
            built([&](int i) { return (nets::in_runs(gates, numbers[o].at(i)) >> r & 1) != 0; }),
            expected[o])
            << "operation " << o << " of " << all[first + r].a << " and " << all[first + r].b;
      }
    }
  }
}

}  // namespace
}  // namespace cosim
