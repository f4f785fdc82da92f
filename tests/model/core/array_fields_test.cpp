// Arrays of values, and records with them: cells, and what a shape does not have.
#include <gtest/gtest.h>

#include <string>

#include "model/core/array.h"
#include "model/core/design.h"
#include "tb/sim/cells.h"
#include "tb/sim/hostile.h"
#include "tests/support/struct_design.h"

namespace cosim::test {
namespace {

using clocked::Array, clocked::UInt, clocked::Int, clocked::Bit;

template <int DEPTH, int WIDTH>
struct Mixed {
  static constexpr const char* name = "mixed";
  struct In {
    UInt<4> first;
    Array<Int<5>, DEPTH> store;
    UInt<WIDTH> line;
    Array<Bit, 1> only;
    UInt<2> last;
  };
  struct Out {
    Bit none;
  };
  Bit held = 0;
  Out clock(const In&) { return {}; }
};
using Design = StructDesign<Mixed<3, 70>, Mixed<4, 192>>;
using Record = Design::Inputs<Word>;

TEST(ArrayFields, LoseWhatAShapeDoesNotHave) {
  const Record r = from_words<Record>({1, 2, 3, 4, 0, 6, 7, 0, 9, 10});
  const Cells<Record> cells(Design::Params{});
  EXPECT_EQ(cells.fields().size(), 8U);
  EXPECT_EQ(cells.words(r), (std::vector<Word>{1, 2, 3, 4, 6, 7, 9, 10}));
  EXPECT_EQ(to_words(cells.record({1, 2, 3, 4, 6, 7, 9, 10})), to_words(r));
}

// Each element takes the ends of its range, and all of them together do; none leaves its width.
TEST(HostileArrays, TakeCornersEachAndAsAWhole) {
  constexpr std::size_t store = 1, line = 5;
  int zeros = 0, ones_of_all = 0, mixed = 0;
  for (std::uint64_t i = 0; i < 20; ++i) {
    HostileStimulus<Design> hostile({}, {3, i, 1000});
    for (Record in; hostile.next(in, {});) {
      const auto words = to_words(in);
      ASSERT_EQ(words[line + 1], low_bits(words[line + 1], 6));
      ASSERT_EQ(words[line + 2], 0) << "not in this shape";
      ASSERT_EQ(words[store + 3], 0) << "not in this shape";
      zeros += words[line] == 0 && words[line + 1] == 0;
      ones_of_all += words[line] == -1 && words[line + 1] == 63;
      mixed += words[line] == -1 && words[line + 1] == 0;
    }
  }
  EXPECT_GT(zeros, 100);
  EXPECT_GT(ones_of_all, 100);
  EXPECT_GT(mixed, 10);
}

TEST(WordArray, StartsAsZerosUnlessGiven) {
  constexpr cosim::Array<Word, 4> zeros;
  constexpr cosim::Array<Word, 4> given{5, 6};
  static_assert(given.size == 4 && given[1] == 6 && given[3] == 0);
  for (const Word w : zeros) EXPECT_EQ(w, 0);
}

TEST(WordArray, HoldsWhatIsPutIntoAnElement) {
  cosim::Array<Word, 3> a;
  a[1] = 7;
  EXPECT_EQ(a.elements, (std::array<Word, 3>{0, 7, 0}));
}

TEST(WordArray, IsSelectedElementByElement) {
  constexpr cosim::Array<Word, 2> a{1, 2}, b{3, 4};
  EXPECT_EQ(select(true, a, b).elements, a.elements);
  EXPECT_EQ(select(false, a, b).elements, b.elements);
}

}  // namespace
}  // namespace cosim::test
