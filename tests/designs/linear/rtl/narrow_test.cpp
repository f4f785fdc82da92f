// The ends of the parameters' ranges that rtl/shipped.txt leaves out: all that fits is drawn.
#include "tb/designs/linear/sweeps.h"
#include "tests/rtl/variant.h"
#include "tests/support/sweeps.h"

namespace cosim::linear {
namespace {

TEST(Narrowest, LinearDrawsEveryLine) {
  for (const char* name : {"m2_n1", "m7_n1"}) {
    const auto& bench = *test::variant<Design>(std::string("shipped/") + name).bench;
    const auto sizes = std::uint64_t{1} << bench.params().m;
    EXPECT_EQ(test::expect_match(every_line(bench)).checked.jobs, sizes * sizes);
  }
}

}  // namespace
}  // namespace cosim::linear
