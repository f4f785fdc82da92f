// One run that matched, with its CSV and its report.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace cosim::cli {

/// A row of the CSV of an arc or a path: clock or segment, dx, dy, x, y.
using StepRow = std::array<std::int64_t, 5>;

struct Drawing {
  Ended ended;
  std::vector<std::string> csv;  ///< lines, the heading first
  nlohmann::json report;

  /// The rows behind the heading, which must be `columns`.
  std::vector<std::vector<std::string>> rows(const std::string& columns) const;
  /// The same of an arc or a path, as numbers.
  std::vector<StepRow> steps(const std::string& first_column) const;
};

/// Runs the command with --csv and --report. Anything but a match is a failure of the test.
Drawing draw(Arguments command);

}  // namespace cosim::cli
