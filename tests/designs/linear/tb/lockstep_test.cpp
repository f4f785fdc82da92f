// The RTL of the linear interpolator in lockstep with its model, every register and output on every
// clock, and against the oracle.
#include <gtest/gtest.h>

#include "tb/designs/linear/figures.h"
#include "tb/designs/linear/sweeps.h"
#include "tb/sim/drawn_sweep.h"
#include "tests/designs/linear/counts.h"
#include "tests/designs/linear/printed.h"
#include "tests/support/lane_sweeps.h"
#include "tests/tb/shape.h"

namespace cosim::linear {
namespace {

using Param = const LinearBench*;

template <class Condition>
auto shapes(Condition condition) {
  return testing::ValuesIn(test::benches_with<Design>(condition));
}
auto all_shapes() { return testing::ValuesIn(benches_of<Design>()); }

class PrintedRoms : public testing::TestWithParam<Param> {};
TEST_P(PrintedRoms, Table1) { printed::expect_table1(*GetParam()); }
TEST_P(PrintedRoms, Table2) { printed::expect_table2(*GetParam()); }
INSTANTIATE_TEST_SUITE_P(Linear, PrintedRoms,
                         shapes([](Params p) { return sizes_of(p).gamma() == 3; }),
                         test::name_of_shape<Param>);

class PrintedRun : public testing::TestWithParam<Param> {};
TEST_P(PrintedRun, Table3) { printed::expect_table3(*GetParam()); }
INSTANTIATE_TEST_SUITE_P(Linear, PrintedRun,
                         shapes([](Params p) { return sizes_of(p).m == 5 && sizes_of(p).n == 2; }),
                         test::name_of_shape<Param>);

class EveryLine : public testing::TestWithParam<Param> {};
TEST_P(EveryLine, Matches) { counted::expect_every_line(*GetParam()); }
INSTANTIATE_TEST_SUITE_P(Linear, EveryLine, shapes([](Params p) { return sizes_of(p).m <= 8; }),
                         test::name_of_shape<Param>);

class RandomLines : public testing::TestWithParam<Param> {};
TEST_P(RandomLines, Match) { counted::expect_random_lines(*GetParam(), 1, 4000); }
INSTANTIATE_TEST_SUITE_P(Linear, RandomLines, all_shapes(), test::name_of_shape<Param>);

// The longest line there is, to the last of its 2^N words, and so the whole range of counter 4 and
// of multiplier 6. Where that is too many words, a line of the first 2^23.
class LongestLine : public testing::TestWithParam<Param> {};
TEST_P(LongestLine, Matches) {
  const Sizes p = sizes_of(GetParam()->params());
  constexpr int kMostBits = 23;
  const Word longest = p.n <= kMostBits ? ones(p.m) : ones(kMostBits + p.gamma());
  const Code every_bit = static_cast<Code>(ones(p.m));
  const Code every_other = every_bit & 0x5555'5555;
  const std::vector<Job> jobs = {{{longest, every_bit}, {}}, {{longest / 2 + 1, every_other}, {}}};
  const auto positions = static_cast<std::uint64_t>(longest + longest / 2 + 1);

  const Result result = drawn<LineFigures, Design>(*GetParam(), jobs, 1);
  EXPECT_TRUE(result.match()) << test::explain(result);
  EXPECT_EQ(result.checked.jobs, jobs.size());
  EXPECT_EQ(result.checked.count("steps"), positions);
}
INSTANTIATE_TEST_SUITE_P(Linear, LongestLine, all_shapes(), test::name_of_shape<Param>);

// First strobe two clocks after the start, then one a clock, ceil(BP / 2^gamma) of them.
class Strobe : public testing::TestWithParam<Param> {};
TEST_P(Strobe, ComesTwoClocksAfterTheStartAndOnEveryClockToTheEnd) {
  const Sizes p = sizes_of(GetParam()->params());
  std::vector<Job> jobs;
  const Word most = std::min(ones(p.m), Word{5 * p.word() + 1});
  for (Word major = 0; major <= most; ++major) jobs.push_back({{major, 1}, {}});
  const auto clocks = printed::draw(*GetParam(), jobs);

  std::size_t at = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const std::int64_t words = (jobs[i].line.major + p.word() - 1) / p.word();
    for (std::int64_t t = -2; t <= words + 2; ++t, ++at) {  // t: clocks after the start
      ASSERT_LT(at, clocks.size());
      ASSERT_EQ(clocks[at].job, i);
      EXPECT_EQ(clocks[at].outputs.strobe, t >= 2 && t < 2 + words)
          << "BP = " << jobs[i].line.major << " clock " << t;
      EXPECT_EQ(clocks[at].outputs.busy, t >= 1 && t < 2 + words)
          << "BP = " << jobs[i].line.major << " clock " << t;
    }
  }
  EXPECT_EQ(at, clocks.size());
}
INSTANTIATE_TEST_SUITE_P(Linear, Strobe, all_shapes(), test::name_of_shape<Param>);

TEST(LinearLanes, SumUpToTheSweepsOfOneCaseAtATime) {
  const LinearBench& smallest = *benches_of<Design>().front();
  for (const Sweep& sweep : {every_line(smallest), random_lines(smallest, 1, 30'000)}) {
    test::expect_same_in_lanes(smallest, sweep, 64);
  }
}

}  // namespace
}  // namespace cosim::linear
