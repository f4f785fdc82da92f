// The device outside, SU 1631518: writes BP and UK, starts the line, waits for its end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/linear/control_code.h"
#include "model/linear/drive.h"
#include "model/linear/view.h"

namespace cosim::linear {

/// A line for the host to draw.
struct Job {
  Line line;
  /// Give the line up through input 17 after so many words, >= 0; a number past the end of the
  /// line gives nothing up.
  std::optional<std::int64_t> words;
};

/// A line takes three clocks to write and start, one until its first word, one a word and one to
/// see the end.
class Host : public DrivingHost<Params, Job, Inputs, Outputs, Task, Driven> {
 public:
  using DrivingHost::DrivingHost;

  /// Simpler lines to try in place of a line that shows a fault, the simplest first. Each is
  /// smaller in one respect and larger in none.
  static std::vector<Job> smaller(const Params& p, const Job& job);
  /// "BP = 27, UK = 01010"
  static std::string describe(const Params& p, const Job& job);
};

}  // namespace cosim::linear
