// Runs sweeps under test: a sweep passes where every case matched and there were as many as asked.
#pragma once

#include <gtest/gtest.h>

#include "tb/util/parallel.h"
#include "tests/support/explain.h"

namespace cosim::test {

inline Result expect_match(const Sweep& sweep) {
  const Result result = run_sweep(sweep, cores());
  EXPECT_TRUE(result.match()) << sweep.name << ", " << result.failed << '\n' << explain(result);
  EXPECT_EQ(result.cases, sweep.cases);
  EXPECT_EQ(result.failed, "");
  return result;
}

}  // namespace cosim::test
