// A fault too deep for hostile clocks: they interrupt a line long before its thousandth word. Whole
// lines find it.
#include <gtest/gtest.h>

#include "tests/designs/linear/records.h"
#include "tests/rtl/straight.h"

namespace cosim::linear {
namespace {

constexpr std::int64_t kTicks = 1024;  // the count that takes the carry into bit 10

test::Script<Design> line_of_words(std::int64_t words) {
  test::Script<Design> script(static_cast<std::size_t>(words) + 6, Design::rest());
  script[0] = Pins{.write_bp = 1, .data = words * 8};
  script[1] = Pins{.write_uk = 1};
  script[2] = Pins{.start = 1};
  return script;
}

// The first word shows on clock 4 and multiplier 6 with it, at 1.
TEST(LinearM16N13LongLine, FindsALostCarryOfTheTickCount) {
  const auto& deep = test::variant<Design>("deep/tick_carry");
  test::expect_found(deep, line_of_words(kTicks), {4 + kTicks - 1, "multiplier6", kTicks, 0});
  test::expect_same(deep, line_of_words(kTicks - 1));
}

TEST(LinearM16N13LongLine, IsDrawnByTheRtlAsShipped) {
  test::expect_same(test::variant<Design>("shipped/m16_n13"), line_of_words(kTicks));
}

}  // namespace
}  // namespace cosim::linear
