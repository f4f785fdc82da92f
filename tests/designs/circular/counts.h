// Sweeps of the circular machine with the number of arcs and steps they must come to.
#pragma once

#include <gtest/gtest.h>

#include <numbers>

#include "tb/designs/circular/sweeps.h"
#include "tests/support/sweeps.h"

namespace cosim::circular::counted {

/// A quarter from (R, 0) takes a step a row up to 45 degrees and then a step a column: R sqrt(2),
/// but for the rounding at either end.
inline void expect_every_radius(const CircularBench& bench, std::int64_t last) {
  const auto radii = static_cast<double>(last);
  const Result result = test::expect_match(every_radius(bench, 1, last));
  EXPECT_EQ(result.checked.jobs, static_cast<std::uint64_t>(last));
  EXPECT_NEAR(static_cast<double>(result.checked.count("steps")),
              std::numbers::sqrt2 * radii * (radii + 1) / 2, 2 * radii);
  // The load, the correction, the end and the clock that shows it.
  EXPECT_EQ(result.clocks, result.checked.count("steps") + 4 * result.checked.jobs);
  EXPECT_LT(result.checked.number("max_deviation"), 0.5);
}

/// A start stands on each row up to 45 degrees and in each column before it; one on the i-th has
/// that many steps less before it.
inline void expect_every_start(const CircularBench& bench, std::int64_t last) {
  double starts = 0, steps = 0;
  for (std::int64_t r = 1; r <= last; ++r) {
    const double quarter = std::numbers::sqrt2 * static_cast<double>(r);
    starts += quarter;
    steps += quarter * quarter / 2;
  }
  const auto radii = static_cast<double>(last);
  const Result result = test::expect_match(every_start(bench, last));
  EXPECT_NEAR(static_cast<double>(result.checked.jobs), starts, 2 * radii);
  EXPECT_NEAR(static_cast<double>(result.checked.count("steps")), steps, 2 * starts + 2 * radii);
  EXPECT_LT(result.checked.number("max_deviation"), 0.5);
}

/// From a start with s steps to the end: stops after 0, 1, .. s steps and one that comes too late.
inline void expect_every_stop(const CircularBench& bench, std::int64_t last) {
  std::uint64_t arcs = 0, steps = 0;
  for (std::int64_t r = 1; r <= last; ++r) {
    const auto radius2 = static_cast<std::uint64_t>(r * r);
    for (const Point& p : every_start(radius2)) {
      const auto whole = static_cast<std::uint64_t>(steps_to_end(p, radius2));
      arcs += whole + 2;
      steps += whole * (whole + 1) / 2 + whole;
    }
  }
  const Result result = test::expect_match(every_stop(bench, last));
  EXPECT_EQ(result.checked.jobs, arcs);
  EXPECT_EQ(result.checked.count("steps"), steps);
}

inline void expect_random_arcs(const CircularBench& bench, std::uint64_t seed,
                               std::uint64_t count) {
  const Result result = test::expect_match(random_arcs(bench, seed, count));
  EXPECT_EQ(result.checked.jobs, count);
  EXPECT_GT(result.checked.count("steps"), count);
  EXPECT_GT(result.clocks, result.checked.count("steps") + 2 * count);
  EXPECT_LT(result.checked.number("max_deviation"), 0.5);
}

}  // namespace cosim::circular::counted
