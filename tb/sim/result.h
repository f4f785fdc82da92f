// What came of one case or, added up, of many.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tb/sim/checked.h"
#include "tb/sim/run.h"

namespace cosim {

struct Result {
  std::uint64_t cases = 0;
  std::uint64_t clocks = 0;  ///< compared
  /// Of each register, then of each output, on how many of them it was left out; may be empty.
  std::vector<std::uint64_t> left_out{};
  Checked checked;  ///< by the design's check, if it has one
  std::optional<Mismatch> mismatch;
  std::string failed;  ///< what the failing case was, one line; empty where none failed
  std::vector<Transactions> streams{};    ///< as of a Run
  std::vector<std::uint64_t> happened{};  ///< as of a Run

  bool match() const { return !mismatch && checked.error.empty(); }
};

/// Adds up place by place; `sum` may be empty.
inline void add(std::vector<std::uint64_t>& sum, const std::vector<std::uint64_t>& one) {
  if (sum.size() < one.size()) sum.resize(one.size());
  for (std::size_t i = 0; i < one.size(); ++i) sum[i] += one[i];
}

/// Adds two results; the first failure stays. What was left out is by place: of one bench, or read
/// by nobody.
inline void add(Result& sum, Result one) {
  if (sum.match() && !one.match()) {
    sum.mismatch = std::move(one.mismatch);
    sum.failed = std::move(one.failed);
  } else {
    one.checked.error.clear();
  }
  sum.cases += one.cases;
  sum.clocks += one.clocks;
  add(sum.left_out, one.left_out);
  add(sum.happened, one.happened);
  add(sum.checked, one.checked);
  add(sum.streams, one.streams);
}

/// The result of one case, and what its design's check found, which does not judge the clock of a
/// mismatch or any later one.
inline Result result_of(Run run, Checked checked = {}, std::string failed = {}) {
  return {1,
          run.clocks,
          std::move(run.left_out),
          std::move(checked),
          std::move(run.mismatch),
          std::move(failed),
          std::move(run.streams),
          std::move(run.happened)};
}

}  // namespace cosim
