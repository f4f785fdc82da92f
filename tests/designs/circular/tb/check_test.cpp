// The check against the oracle, shown right and wrong machines made up clock by clock.
#include "tb/designs/circular/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace cosim::circular {
namespace {

using ArcSeen = Compared<Design>;

// R = 12, the source's example.

const std::vector<Arc> kArcs = {{{12, 0}, 144, {}}, {{8, 9}, 144, {}}, {{12, 0}, 144, 3}};
const std::vector<std::string> kSteps = {"|||/|/|//=/-/-/---=", "/-/-/---=", "|||"};

Checked checked(const std::vector<std::string>& steps) {
  Check check(kArcs);
  for (std::size_t job = 0; job < steps.size(); ++job) {
    for (const char c : steps[job]) {
      ArcSeen seen{};
      seen.outputs.running = 1;
      seen.outputs.step_y = c == '|' || c == '/';
      seen.outputs.step_x = c == '-' || c == '/';
      check.clock(job, seen);
    }
  }
  return check.finish();
}

TEST(ArcCheck, PassesWhatTheSourcePrints) {
  const Checked found = checked(kSteps);
  EXPECT_EQ(found.error, "");
  EXPECT_EQ(found.jobs, 3U);
  EXPECT_EQ(found.count("steps"), 17U + 8 + 3);
  // The farthest points are (12, 3) and its mirror image.
  EXPECT_NEAR(found.number("max_deviation"), std::sqrt(153.0) - 12, 1e-9);
}

TEST(ArcCheck, SeesEveryWrongStep) {
  for (std::size_t job = 0; job < kSteps.size(); ++job) {
    for (std::size_t i = 0; i < kSteps[job].size(); ++i) {
      for (const char c : {'|', '/', '-', '='}) {
        auto steps = kSteps;
        if (steps[job][i] == c) continue;
        steps[job][i] = c;
        EXPECT_NE(checked(steps).error, "") << "arc " << job << " step " << i << " as " << c;
      }
    }
  }
}

TEST(ArcCheck, NamesTheStep) {
  auto steps = kSteps;
  steps[0][1] = '/';
  EXPECT_EQ(checked(steps).error,
            "R^2 = 144, step 2 from (12, 1): oracle (12, 2), machine (11, 2)");
}

TEST(ArcCheck, CountsTheSteps) {
  EXPECT_EQ(checked({kSteps[0], "/-/-/--=", kSteps[2]}).error,
            "R^2 = 144 from (8, 9): oracle 8 steps, machine 7");
  EXPECT_EQ(checked({kSteps[0], kSteps[1], "|||/"}).error,
            "R^2 = 144 from (12, 0): oracle 3 steps, machine 4");
  EXPECT_EQ(checked({kSteps[0], "/-/-/----", kSteps[2]}).error,
            "R^2 = 144: a step past the end, at (0, 12)");
  EXPECT_NE(checked(std::vector<std::string>{}).error, "");
}

}  // namespace
}  // namespace cosim::circular
