// What is measured of jobs that draw paths.
#pragma once

#include <algorithm>
#include <cstdint>

#include "tb/sim/checked.h"

namespace cosim {

/// Of one path or of several.
struct PathFigures {
  std::uint64_t steps = 0;
  double max_deviation = 0;

  void deviates(double so_far) { max_deviation = std::max(max_deviation, so_far); }
  /// The same of what exact() gives, which is asked only where it may be the largest: it is `about`
  /// that, within a millionth of it.
  template <class Exact>
  void deviates(double about, Exact exact) {
    if (!(about * (1 + 1e-6) < max_deviation)) deviates(exact());
  }
  Checked checked() const {
    Checked found;
    found.measures = {
        {"steps", Measure::Sum::total, "", "step", steps},
        {"max_deviation", Measure::Sum::largest, "largest deviation", "step", max_deviation}};
    return found;
  }
};

}  // namespace cosim
