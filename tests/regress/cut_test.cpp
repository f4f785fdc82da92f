// Every unit is in one shard and no shard is empty, whatever the numbers.
#include "tb/regress/run_folder.h"

#include <gtest/gtest.h>

#include "tb/regress/worker.h"
#include "tb/util/random.h"

namespace cosim::regress {
namespace {

void expect_all_once(const std::vector<Size>& works, const std::vector<Shard>& shards) {
  std::size_t s = 0;
  for (std::size_t w = 0; w < works.size(); ++w) {
    std::uint64_t next = 0;
    for (; s < shards.size() && shards[s].work == w; ++s) {
      ASSERT_EQ(shards[s].first, next);
      ASSERT_LT(shards[s].first, shards[s].last);
      next = shards[s].last;
    }
    ASSERT_EQ(next, works[w].units);
  }
  ASSERT_EQ(s, shards.size());
}

TEST(Cut, HasEveryUnitOnce) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    std::vector<Size> works(1 + random.below(5));
    for (Size& one : works) {
      one.units = 1 + random.below(std::uint64_t{1} << random.below(49));
      one.minutes = static_cast<double>(1 + random.below(1000)) / 7;
    }
    const std::uint64_t shards = 1 + random.below(2000);
    expect_all_once(works, cut(works, shards));
  }
}

TEST(Cut, IsByTime) {
  const auto shards = cut({{1000, 9}, {1000, 1}}, 100);
  ASSERT_EQ(shards.size(), 100U);
  EXPECT_EQ(shards[89].work, 0U);
  EXPECT_EQ(shards[90].work, 1U);
  EXPECT_EQ(usual_shards({{1000, 9}, {1000, 1.5}}), 11U);
  EXPECT_EQ(cut({{3, 1}}, 100).size(), 3U);
  EXPECT_EQ(cut({{3, 1}, {1, 1}, {8, 1}}, 1).size(), 3U);
}

TEST(List, IsReadAsItIsWritten) {
  EXPECT_EQ(list_of({0, 1, 2, 3, 7, 9, 10}), "0-3,7,9-10");
  EXPECT_EQ(shards_in("0-3,7,9-10", 11, "x"), (std::vector<std::uint64_t>{0, 1, 2, 3, 7, 9, 10}));
  for (const char* text : {"", "a", "3-1", "1-", "11", "0-11", "1,,2", "-1", "9999999999"}) {
    EXPECT_ANY_THROW(shards_in(text, 11, "x")) << text;
  }
}

}  // namespace
}  // namespace cosim::regress
