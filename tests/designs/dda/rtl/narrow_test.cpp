// The ends of the parameters' ranges that rtl/shipped.txt leaves out: all that fits is drawn.
#include "tb/designs/dda/sweeps.h"
#include "tests/rtl/variant.h"
#include "tests/support/sweeps.h"

namespace cosim::dda {
namespace {

TEST(Narrowest, DdaDrawsEveryLineAndQuarter) {
  const auto& bench = *test::variant<Design>("shipped/w2").bench;
  test::expect_match(every_line(bench));
  EXPECT_EQ(test::expect_match(every_quarter(bench)).checked.jobs, 4U * 3);
  test::expect_match(random_jobs(bench, 1, 500));
}

}  // namespace
}  // namespace cosim::dda
