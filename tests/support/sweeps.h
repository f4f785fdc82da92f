// Runs sweeps under test: a sweep passes where every case matched and there were as many as asked.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "tests/support/explain.h"

namespace cosim::test {

inline Result expect_match(const Sweep& sweep) {
  const Result result = run_sweep(sweep, std::max(std::thread::hardware_concurrency(), 1U));
  EXPECT_TRUE(result.match()) << sweep.name << ", " << result.failed << '\n' << explain(result);
  EXPECT_EQ(result.cases, sweep.cases);
  EXPECT_EQ(result.failed, "");
  return result;
}

}  // namespace cosim::test
