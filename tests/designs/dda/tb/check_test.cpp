// The check against the oracle, shown right and wrong machines.
#include "tb/designs/dda/check.h"

#include <gtest/gtest.h>

#include "tests/support/model_adapter.h"
#include "tests/support/recorder.h"

namespace cosim::dda {
namespace {

using Seen = Compared<Design>;

constexpr Params kP{6};
const std::vector<Job> kJobs{line(kP, {27, 9}, {}), line(kP, {-3, 2}, {})};

std::vector<std::pair<std::size_t, Seen>> right_clocks() {
  std::vector<std::pair<std::size_t, Seen>> all;
  for (const auto& c : test::draw(test::model_bench<Design, kP>(), std::span<const Job>(kJobs))) {
    all.push_back({c.job, {c.registers, c.outputs}});
  }
  return all;
}

Checked checked(const std::vector<std::pair<std::size_t, Seen>>& clocks) {
  Check check(kP, kJobs);
  for (const auto& [job, seen] : clocks) check.clock(job, seen);
  return check.finish();
}

TEST(DdaCheck, PassesTheModel) {
  const Checked found = checked(right_clocks());
  EXPECT_EQ(found.error, "");
  EXPECT_EQ(found.jobs, 2U);
  EXPECT_EQ(found.count("steps"), 27U + 3);
  EXPECT_GT(found.number("max_deviation"), 0);
}

TEST(DdaCheck, SeesAnyWrongStepOrCode) {
  const auto right = right_clocks();
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (right[i].second.outputs.busy == 0) continue;
    for (auto member : {&Outputs<Word>::x_up, &Outputs<Word>::y_down, &Outputs<Word>::code_x,
                        &Outputs<Word>::code_y}) {
      auto wrong = right;
      wrong[i].second.outputs.*member ^= 1;
      EXPECT_NE(checked(wrong).error, "") << "clock " << i;
    }
  }
}

TEST(DdaCheck, SeesAnEndThatComesEarly) {
  auto wrong = right_clocks();
  for (std::size_t i = wrong.size() - 3; i < wrong.size(); ++i) wrong[i].second.outputs.busy = 0;
  EXPECT_NE(checked(wrong).error, "");
}

}  // namespace
}  // namespace cosim::dda
