// The checks against the oracles, shown right and wrong machines made up clock by clock.
#include "tb/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace cosim {
namespace {

using LineSeen = Compared<linear::Design>;
using ArcSeen = Compared<circular::Design>;

// ---- Lines: m = 5, n = 2, the source's example -------------------------------------------------

const std::vector<linear::Job> kLines = {{{27, 0b01010}, {}}, {{8, 0b11111}, {}}};

LineSeen words(Word major, Word minor) {
  LineSeen seen{};
  seen.outputs.busy = seen.outputs.strobe = 1;
  seen.outputs.major = major;
  seen.outputs.minor = minor;
  return seen;
}

struct Pair {
  std::size_t job;
  LineSeen seen;
};

std::vector<Pair> right_lines() {
  return {{0, words(0b11111111, 0b01000101)},
          {0, words(0b11111111, 0b01000100)},
          {0, words(0b11111111, 0b01000101)},
          {0, words(0b11100000, 0b01000000)},
          {1, words(0b11111111, 0b11111111)}};
}

Checked checked(const std::vector<Pair>& clocks, std::span<const linear::Job> jobs = kLines) {
  LineCheck check({5, 2}, jobs);
  for (const Pair& c : clocks) {
    check.clock(c.job, LineSeen{});  // a clock without a strobe in between
    check.clock(c.job, c.seen);
  }
  return check.finish();
}

TEST(LineCheck, PassesWhatTheSourcePrints) {
  const Checked found = checked(right_lines());
  EXPECT_EQ(found.error, "");
  EXPECT_EQ(found.jobs, 2U);
  EXPECT_EQ(found.steps, 27U + 8);
  EXPECT_GT(found.max_deviation, 0);
}

TEST(LineCheck, SeesEveryWrongBit) {
  for (std::size_t i = 0; i < 5; ++i) {
    for (int b = 0; b < 8; ++b) {
      auto clocks = right_lines();
      clocks[i].seen.outputs.major ^= Word{1} << b;
      EXPECT_NE(checked(clocks).error, "");
      clocks = right_lines();
      clocks[i].seen.outputs.minor ^= Word{1} << b;
      EXPECT_NE(checked(clocks).error, "");
    }
  }
}

TEST(LineCheck, NamesTheWord) {
  auto clocks = right_lines();
  clocks[1].seen.outputs.minor = 0b01000101;
  EXPECT_EQ(checked(clocks).error,
            "BP = 27, UK = 01010, word 2: oracle 11111111 01000100, machine 11111111 01000101");
}

TEST(LineCheck, CountsTheWords) {
  for (std::size_t i = 0; i < 5; ++i) {
    auto clocks = right_lines();
    clocks.erase(clocks.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_NE(checked(clocks).error, "") << "without word " << i;
  }
  auto clocks = right_lines();
  clocks.pop_back();
  EXPECT_EQ(checked(clocks).error, "BP = 8, UK = 11111: oracle 1 words, machine 0");
  clocks = right_lines();
  clocks.push_back({1, words(0, 0)});  // a strobe with nothing in it
  EXPECT_EQ(checked(clocks).error, "BP = 8, UK = 11111: oracle 1 words, machine 2");
}

TEST(LineCheck, SeesALineThatWasNeverDrawn) { EXPECT_NE(checked(std::vector<Pair>{}).error, ""); }

TEST(LineCheck, LetsALineBeGivenUp) {
  const std::vector<linear::Job> jobs = {{{27, 0b01010}, 2}, {{8, 0b11111}, {}}};
  auto clocks = right_lines();
  clocks.erase(clocks.begin() + 2, clocks.begin() + 4);
  EXPECT_EQ(checked(clocks, jobs).error, "");
  EXPECT_EQ(checked(clocks, jobs).jobs, 2U);
}

// ---- Arcs: R = 12, the source's example ---------------------------------------------------------

const std::vector<circular::Arc> kArcs = {{{12, 0}, 144, {}}, {{8, 9}, 144, {}}, {{12, 0}, 144, 3}};
const std::vector<std::string> kSteps = {"|||/|/|//=/-/-/---=", "/-/-/---=", "|||"};

Checked checked(const std::vector<std::string>& steps) {
  ArcCheck check(kArcs);
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
  EXPECT_EQ(found.steps, 17U + 8 + 3);
  // The farthest points are (12, 3) and its mirror image.
  EXPECT_NEAR(found.max_deviation, std::sqrt(153.0) - 12, 1e-9);
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
}  // namespace cosim
