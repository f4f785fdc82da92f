// Arrays of values, and tables with them: members, cells, and what a shape does not have.
#include <gtest/gtest.h>

#include <string>

#include "model/core/array.h"
#include "model/core/design.h"
#include "tb/sim/cells.h"
#include "tb/sim/hostile.h"
#include "tests/support/error_of.h"

namespace cosim::test {
namespace {

struct ArraySizes {
  int depth = 3;
  int width = 70;
};
#define MIXED_FIELDS(FIELD)                                             \
  FIELD(first, 4, number, "", "")                                       \
  FIELD(store, 5, twos_complement.array<4>(p.depth).unreset(), "7", "") \
  FIELD(line, p.width, bits.words<3>().at("unit.line"), "", "")         \
  FIELD(only, 1, flag.array<1>(), "", "")                               \
  FIELD(last, 2, bits, "", "")
COSIM_RECORD(Mixed, MIXED_FIELDS, ArraySizes);
using Record = Mixed<Word>;

TEST(ArrayFields, AreMembersOfTheirCapacity) {
  static_assert(Record::has_arrays && Record::size == 1 + 4 + 3 + 1 + 1);
  static_assert(std::is_same_v<decltype(Record::store), Array<Word, 4>>);
  static_assert(std::is_same_v<decltype(Record::only), Array<Word, 1>>);
  static_assert(std::is_same_v<decltype(Record::last), Word>);
  static_assert(Record::index_line == 5 && Record::index_last == 9);
}

TEST(ArrayFields, AreCellsInTheOrderOfTheTable) {
  Record r;
  r.first = 1;
  r.store[3] = 2;
  r.line[0] = 3;
  r.only[0] = 4;
  r.last = 5;
  const Words<Record> words{1, 0, 0, 0, 2, 3, 0, 0, 4, 5};
  EXPECT_EQ(to_words(r), words);
  EXPECT_EQ(to_words(from_words<Record>(words)), words);
  Record other;
  other.store[0] = 9;
  EXPECT_EQ(to_words(select(false, r, other)), to_words(other));
}

TEST(ArrayFields, DescribeEachCell) {
  const auto f = Record::fields({});
  const auto is = [&](std::size_t i, const std::string& label, int width, int low) {
    EXPECT_EQ(label_of(f[i]), label);
    EXPECT_EQ(f[i].width, width) << label;
    EXPECT_EQ(f[i].low, low) << label;
  };
  is(0, "first", 4, 0);
  is(1, "store[0]", 5, 0);
  is(3, "store[2]", 5, 10);
  is(5, "line[63:0]", 64, 0);
  is(6, "line[69:64]", 6, 64);
  is(9, "last", 2, 0);
  EXPECT_EQ(f[4].width, 0) << "not in this shape";
  EXPECT_EQ(f[7].width, 0) << "not in this shape";
  EXPECT_TRUE(f[2].unreset);
  EXPECT_STREQ(f[2].source, "7");
  EXPECT_STREQ(f[6].net, "unit.line");
  EXPECT_EQ(Record::fields({4, 192})[7].width, 64);
}

TEST(ArrayFields, ThatDoNotFitAreRefused) {
  const auto refusal = [](const ArraySizes& p) {
    return test::error_of([&] { Record::fields(p); });
  };
  EXPECT_EQ(refusal({4, 192}), "");
  EXPECT_EQ(refusal({5, 70}), "store: 5 elements, and its array holds 1 to 4");
  EXPECT_EQ(refusal({0, 70}), "store: 0 elements, and its array holds 1 to 4");
  EXPECT_EQ(refusal({3, 193}), "line: 4 elements, and its array holds 1 to 3");
}

TEST(ArrayFields, LoseWhatAShapeDoesNotHave) {
  Record r = from_words<Record>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  Record::trim({}, r);
  EXPECT_EQ(to_words(r), (Words<Record>{1, 2, 3, 4, 0, 6, 7, 0, 9, 10}));
  const Cells<Record> cells(ArraySizes{});
  EXPECT_EQ(cells.fields().size(), 8U);
  EXPECT_EQ(cells.words(r), (std::vector<Word>{1, 2, 3, 4, 6, 7, 9, 10}));
  EXPECT_EQ(to_words(cells.record({1, 2, 3, 4, 6, 7, 9, 10})), to_words(r));
}

// Registers hold a sign as a code, in each element.
TEST(ArrayFields, AreCodesInRegisters) {
  Record r;
  r.store[1] = -1;
  EXPECT_EQ(detail::registers_of(ArraySizes{}, r).store[1], 31);
}

struct Wide {
  using Params = ArraySizes;
  template <class V>
  using Inputs = Mixed<V>;
  template <class V>
  using Outputs = Mixed<V>;
  template <class V>
  using State = Mixed<V>;
  static constexpr Mixed<Word> reset_inputs() { return {.first = 1}; }
};

// Each element takes the ends of its range, and all of them together do; none leaves its width.
TEST(HostileArrays, TakeCornersEachAndAsAWhole) {
  int zeros = 0, ones_of_all = 0, mixed = 0;
  for (std::uint64_t i = 0; i < 20; ++i) {
    HostileStimulus<Wide> hostile({}, {3, i, 1000});
    for (Mixed<Word> in; hostile.next(in, {});) {
      ASSERT_EQ(in.line[0], low_bits(in.line[0], 64));
      ASSERT_EQ(in.line[1], low_bits(in.line[1], 6));
      ASSERT_EQ(in.line[2], 0) << "not in this shape";
      ASSERT_EQ(in.store[3], 0) << "not in this shape";
      zeros += in.line[0] == 0 && in.line[1] == 0;
      ones_of_all += in.line[0] == -1 && in.line[1] == 63;
      mixed += in.line[0] == -1 && in.line[1] == 0;
    }
  }
  EXPECT_GT(zeros, 100);
  EXPECT_GT(ones_of_all, 100);
  EXPECT_GT(mixed, 10);
}

TEST(Array, StartsAsZerosUnlessGiven) {
  constexpr Array<Word, 4> zeros;
  constexpr Array<Word, 4> given{5, 6};
  static_assert(given.size == 4 && given[1] == 6 && given[3] == 0);
  for (const Word w : zeros) EXPECT_EQ(w, 0);
}

TEST(Array, HoldsWhatIsPutIntoAnElement) {
  Array<Word, 3> a;
  a[1] = 7;
  EXPECT_EQ(a.elements, (std::array<Word, 3>{0, 7, 0}));
}

TEST(Array, IsSelectedElementByElement) {
  constexpr Array<Word, 2> a{1, 2}, b{3, 4};
  EXPECT_EQ(select(true, a, b).elements, a.elements);
  EXPECT_EQ(select(false, a, b).elements, b.elements);
}

}  // namespace
}  // namespace cosim::test
