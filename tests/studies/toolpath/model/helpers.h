// What the toolpath tests share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/linear/control_code.h"
#include "model/toolpath/gcode.h"
#include "model/toolpath/plan.h"
#include "model/toolpath/walk.h"
#include "tests/support/error_of.h"

namespace cosim::toolpath {

inline Program read(std::string_view text) { return read_gcode(text, "p.ngc"); }

using test::error_of;

/// Every step of the plan, by an 18-bit machine with greedy codes.
inline std::vector<Step> walked(const Plan& plan) {
  std::vector<Step> path;
  walk(plan, 18, linear::greedy_code, [&](const Step& step) { path.push_back(step); });
  return path;
}

/// Empty where each step follows from the one before by one elementary step and each segment ends
/// on its target; else what is wrong, with the step.
inline std::string flaw(const Plan& plan, const std::vector<Step>& path) {
  Point at;
  std::size_t step = 0;
  for (std::size_t i = 0; i < plan.segments.size(); ++i) {
    for (; step < path.size() && path[step].segment == i + 1; ++step) {
      const Step& s = path[step];
      const bool elementary = s.dx >= -1 && s.dx <= 1 && s.dy >= -1 && s.dy <= 1;
      if (!elementary || (s.dx == 0 && s.dy == 0)) return "no step: " + std::to_string(step);
      at = {at.x + s.dx, at.y + s.dy};
      if (!(at == s.at)) return "not connected: " + std::to_string(step);
    }
    if (!(at == plan.segments[i].end)) return "off target: segment " + std::to_string(i + 1);
  }
  return step == path.size() ? "" : "segments out of order: " + std::to_string(step);
}

}  // namespace cosim::toolpath
