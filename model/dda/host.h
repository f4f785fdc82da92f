// The device outside: writes the registers for a curve, starts it, waits for its end or stops it.
#pragma once

#include <string>
#include <vector>

#include "model/dda/drive.h"
#include "model/dda/view.h"

namespace cosim::dda {

/// A job takes twelve clocks to write and start, those it runs, and one or two to end.
class Host : public DrivingHost<Params, Job, Inputs, Outputs, Task, Driven> {
 public:
  using DrivingHost::DrivingHost;

  /// Simpler jobs to try in place of a job that shows a fault, the simplest first. Each is smaller
  /// in one respect and larger in none. Each of them ends.
  static std::vector<Job> smaller(const Params& p, const Job& job);
  /// "rates (27, 9) from (0, 0), 27 and 9 steps"
  static std::string describe(const Params& p, const Job& job);
};

}  // namespace cosim::dda
