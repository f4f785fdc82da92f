// The ends of the parameters' ranges that rtl/shipped.txt leaves out: all that fits is drawn.
#include "tb/designs/circular/sweeps.h"
#include "tests/rtl/variant.h"
#include "tests/support/sweeps.h"

namespace cosim::circular {
namespace {

TEST(Narrowest, CircularDrawsEveryArc) {
  const auto& bench = *test::variant<Design>("shipped/w2").bench;
  EXPECT_EQ(test::expect_match(every_radius(bench, 1, 3)).checked.jobs, 3U);
  test::expect_match(every_start(bench, 3));
  test::expect_match(every_stop(bench, 3));
  test::expect_match(random_arcs(bench, 1, 500));
}

}  // namespace
}  // namespace cosim::circular
