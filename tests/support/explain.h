// A test that finds RTL and model apart leaves a failure folder, as the command line does.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <exception>
#include <string>

#include "tb/sim/failure.h"
#include "tb/sim/sweep.h"

namespace cosim::test {

/// The mismatch as text, and where its folder is: in $COSIM_FAILURES, else in failures/. `what` is
/// the case; where it is empty, the name of the test.
inline std::string explain(const Mismatch& mismatch, std::string what = {}) {
  std::string text = to_text(mismatch);
  if (mismatch.bench == nullptr) return text;
  if (const auto* test = testing::UnitTest::GetInstance()->current_test_info(); what.empty()) {
    what = std::string(test->test_suite_name()) + "." + test->name();
  }
  FailureOptions options;
  if (const char* folder = std::getenv("COSIM_FAILURES")) options.root = folder;
  try {
    return text + to_text(leave_failure(*mismatch.bench, what, mismatch, options));
  } catch (const std::exception& e) {
    return text + "no failure folder: " + e.what() + '\n';
  }
}

/// What went wrong in a sweep's or a set of jobs' result.
inline std::string explain(const Result& result) {
  return result.mismatch ? explain(*result.mismatch, result.failed) : result.checked.error;
}

}  // namespace cosim::test
