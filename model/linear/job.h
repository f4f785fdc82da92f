// What the linear machine is given to do, SU 1631518: a line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/linear/control_code.h"

namespace cosim::linear {

/// A line to draw.
struct Job {
  Line line;
  /// Give the line up through input 17 after this many words, >= 0; a number past the end of the
  /// line gives nothing up.
  std::optional<std::int64_t> words;
};

/// Simpler lines to try in place of a line that shows a fault, the simplest first. Each is smaller
/// in one respect and larger in none. m: bits of BP and of the code.
std::vector<Job> smaller(int m, const Job& job);
/// "BP = 27, UK = 01010"
std::string describe(int m, const Job& job);

}  // namespace cosim::linear
