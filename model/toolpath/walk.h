// The whole path of a plan, from the definitions of the machines alone: what any run of the
// machines has to give.
#pragma once

#include <cstdint>
#include <functional>

#include "model/linear/control_code.h"
#include "model/toolpath/plan.h"

namespace cosim::toolpath {

/// One elementary step in machine coordinates: -1, 0 or 1 on each axis and not 0 on both, and the
/// position after it. A row of the path's CSV.
struct Step {
  std::uint32_t segment = 0;
  int dx = 0;
  int dy = 0;
  Point at;
  friend bool operator==(const Step&, const Step&) = default;
};

/// Chooses the control code of a line, as greedy_code and best_code do: (m, major, minor).
using CodeChooser = std::function<linear::Code(int, std::int64_t, std::int64_t)>;

/// Calls `sink` with every step in order and returns the last position. Takes constant memory.
/// plan.longest_line < 2^m, m <= 32.
Point walk(const Plan& plan, int m, const CodeChooser& choose,
           const std::function<void(const Step&)>& sink);

}  // namespace cosim::toolpath
