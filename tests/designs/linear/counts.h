// Sweeps of the linear machine with the number of lines, positions and clocks they must come to.
#pragma once

#include <gtest/gtest.h>

#include "tb/designs/linear/sweeps.h"
#include "tests/support/sweeps.h"

namespace cosim::linear::counted {

/// Every BP with every UK. A line takes three clocks to write and start, one until its first word,
/// one a word and one to see the end.
inline void expect_every_line(const LinearBench& bench) {
  const std::uint64_t lines = std::uint64_t{1} << sizes_of(bench.params()).m;
  const auto word = static_cast<std::uint64_t>(sizes_of(bench.params()).word());
  std::uint64_t positions = 0, clocks = 0;
  for (std::uint64_t major = 0; major < lines; ++major) {
    positions += major;
    clocks += 5 + (major + word - 1) / word;
  }
  const Result result = test::expect_match(every_line(bench));
  EXPECT_EQ(result.cases, lines);
  EXPECT_EQ(result.checked.jobs, lines * lines);
  EXPECT_EQ(result.checked.count("steps"), lines * positions);
  EXPECT_EQ(result.clocks, lines * clocks);
}

/// `count` random lines; most of them have words to draw.
inline void expect_random_lines(const LinearBench& bench, std::uint64_t seed, std::uint64_t count) {
  const Result result = test::expect_match(random_lines(bench, seed, count));
  EXPECT_EQ(result.checked.jobs, count);
  EXPECT_GT(result.clocks, 5 * count);
  EXPECT_GT(result.checked.count("steps"), count);
}

}  // namespace cosim::linear::counted
