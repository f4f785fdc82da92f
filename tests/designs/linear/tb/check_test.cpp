// The check against the oracle, shown right and wrong machines made up clock by clock.
#include "tb/designs/linear/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace cosim::linear {
namespace {

using LineSeen = Compared<Design>;
// M = 5, n = 2, the source's example.

const std::vector<Job> kLines = {{{27, 0b01010}, {}}, {{8, 0b11111}, {}}};

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

Checked checked(const std::vector<Pair>& clocks, std::span<const Job> jobs = kLines) {
  Check check({5, 2}, jobs);
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
  EXPECT_EQ(found.count("steps"), 27U + 8);
  EXPECT_GT(found.number("max_deviation"), 0);
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
  const std::vector<Job> jobs = {{{27, 0b01010}, 2}, {{8, 0b11111}, {}}};
  auto clocks = right_lines();
  clocks.erase(clocks.begin() + 2, clocks.begin() + 4);
  EXPECT_EQ(checked(clocks, jobs).error, "");
  EXPECT_EQ(checked(clocks, jobs).jobs, 2U);
}

}  // namespace
}  // namespace cosim::linear
