// Arrays of values.
#include "model/core/array.h"

#include <gtest/gtest.h>

namespace cosim::test {
namespace {

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
