// The jobs that mutants of the DDA are attacked with, as a campaign runs them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tb/designs/dda/mutation/jobs.h"

namespace cosim::mutation {
namespace {

// Behind a job that takes 2^32 clocks nothing is ever run, so each but the last must be short.
TEST(DdaMutants, MeetTheShortJobsBeforeTheEndlessOne) {
  const dda::Params p = dda::Design::shape_of({32});
  for (std::uint64_t i = 0; i < long_jobs; ++i) {
    const auto jobs = Jobs<dda::Design>::longest(p, campaign_seed, i);
    ASSERT_FALSE(jobs.empty());
    EXPECT_FALSE(jobs.back().clocks) << i;
    EXPECT_TRUE(std::all_of(jobs.begin(), jobs.end() - 1, [](const dda::Job& job) {
      return job.clocks && *job.clocks <= 128;
    })) << i;
  }
}

// A mutant that does not see one digit of the steps left ends such a line before its first step.
TEST(DdaMutants, MeetEachDigitOfTheStepsLeftAlone) {
  const dda::Params p = dda::Design::shape_of({32});
  Word seen_x = 0, seen_y = 0;
  for (std::uint64_t i = 0; i < long_jobs; ++i) {
    for (const dda::Job& job : Jobs<dda::Design>::longest(p, campaign_seed, i)) {
      const auto alone = [](Word left) { return left != 0 && (left & (left - 1)) == 0; };
      if (alone(job.start.left_x) && alone(job.start.left_y)) {
        seen_x |= job.start.left_x;
        seen_y |= job.start.left_y;
      }
    }
  }
  EXPECT_EQ(seen_x, 0xFFFF'FFFFU);
  EXPECT_EQ(seen_y, 0xFFFF'FFFFU);
}

}  // namespace
}  // namespace cosim::mutation
