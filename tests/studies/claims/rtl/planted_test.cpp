// The results page says how many faults are planted in all designs, and how far they shrink.
#include "tests/rtl/planted.h"

#include <gtest/gtest.h>

#include "tb/util/pattern.h"
#include "tb/util/read_file.h"
#include "tests/rtl/variant.h"
#include "tests/support/designs.h"
#include "tests/support/root.h"

namespace cosim::test {
namespace {

TEST(Planted, AreAsManyAndShrinkAsFarAsThePageSays) {
  const std::string text = read_file((project_root() / "docs/interpolators/results.md").string());
  const Pattern sentence(
      "Each of (\\d+)\\splanted\\sfaults\\sand\\smisprints\\sshrinks\\sto\\s(\\d+)\\sclocks");
  const auto found = sentence.all(text);
  ASSERT_EQ(found.size(), 1U);
  std::size_t planted = 0;
  for_each_design([&]<class Design>() {
    for (const auto& v : variants<Design>()) planted += is_planted(v.name) ? 1 : 0;
  });
  EXPECT_EQ(found[0][1], std::to_string(planted));
  EXPECT_EQ(found[0][2], std::to_string(most_clocks_shrunk));
}

}  // namespace
}  // namespace cosim::test
