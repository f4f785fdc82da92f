// Any value on any pin on any clock: RTL and model agree all the same, for a million clocks of
// every shape one case at a time, and in lanes for 10^10 of a shape of each design.
#include "tests/support/sweeps.h"
#include "tests/tb/shape.h"

namespace cosim::test {
namespace {

using Param = const AnyBench*;
constexpr std::uint64_t kClocks = 1'000'000;

class Hostile : public testing::TestWithParam<Param> {};
TEST_P(Hostile, Matches) {
  const Result result = expect_match(hostile_sweep(*GetParam(), 1, kClocks));
  EXPECT_EQ(result.clocks, kClocks);
  EXPECT_EQ(result.cases, kClocks / 1000);
}
INSTANTIATE_TEST_SUITE_P(AnyPin, Hostile, testing::ValuesIn(all_benches()), name_of_bench);

}  // namespace
}  // namespace cosim::test
