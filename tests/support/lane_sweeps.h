// Sweeps of jobs in lanes beside the same one case at a time.
#pragma once

#include <gtest/gtest.h>

#include "tests/support/in_lanes.h"
#include "tests/support/sweeps.h"

namespace cosim::test {

inline void expect_equal(const Checked& together, const Checked& alone) {
  EXPECT_EQ(together.jobs, alone.jobs);
  EXPECT_EQ(together.error, alone.error);
  ASSERT_EQ(together.measures.size(), alone.measures.size());
  for (std::size_t i = 0; i < alone.measures.size(); ++i) {
    EXPECT_EQ(to_text(together.measures[i]), to_text(alone.measures[i]));
  }
}

/// As they sum up, and where they fail.
inline void expect_equal(const Result& together, const Result& alone) {
  EXPECT_EQ(together.cases, alone.cases);
  EXPECT_EQ(together.clocks, alone.clocks);
  expect_equal(together.checked, alone.checked);
  EXPECT_EQ(together.failed, alone.failed);
  ASSERT_EQ(together.mismatch.has_value(), alone.mismatch.has_value());
  if (!alone.mismatch) return;
  EXPECT_EQ(together.mismatch->clock, alone.mismatch->clock);
  EXPECT_EQ(together.mismatch->signal, alone.mismatch->signal);
  EXPECT_EQ(together.mismatch->expected, alone.mismatch->expected);
  EXPECT_EQ(together.mismatch->actual, alone.mismatch->actual);
  EXPECT_EQ(together.mismatch->stimulus.clocks, alone.mismatch->stimulus.clocks);
}

/// The sums are the same for any number of threads, and wherever it was interrupted.
inline void expect_same_in_lanes(const AnyBench& bench, const Sweep& sweep, int lanes) {
  SCOPED_TRACE(sweep.name + " in " + std::to_string(lanes));
  const Result alone = expect_match(sweep);
  const auto built = jobs_in_lanes(bench, lanes);
  const Sweep some = lanes::job_sweep(bench, *built, sweep);
  for (const unsigned threads : {1U, 2U}) {
    for (const std::uint64_t done : {std::uint64_t{0}, sweep.cases / 3}) {
      Resume resume;
      Sweep first = sweep;
      first.cases = done;
      if (done != 0) resume.done = run_sweep(first, 1);
      const Result together = run_sweep(some, threads, {}, resume);
      EXPECT_TRUE(together.match()) << explain(together);
      expect_equal(together, alone);
    }
  }
}

/// It fails in lanes as it fails one case at a time.
inline void expect_same_failure(const AnyBench& bench, const Sweep& sweep,
                                const lanes::Built& built) {
  const Result alone = run_sweep(sweep, 1);
  ASSERT_FALSE(alone.match());
  for (const unsigned threads : {1U, 2U}) {
    expect_equal(run_sweep(lanes::job_sweep(bench, built, sweep), threads), alone);
  }
}

}  // namespace cosim::test
