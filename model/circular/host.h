// The device outside, SU 1665343: loads an arc, starts it, waits for its end or stops it.
#pragma once

#include <string>
#include <vector>

#include "model/circular/drive.h"
#include "model/circular/view.h"

namespace cosim::circular {

/// An arc takes one clock to load and start, then a clock a step, one more for a sector change and
/// one or two to end.
class Host : public DrivingHost<Params, Arc, Inputs, Outputs, Task, Driven> {
 public:
  using DrivingHost::DrivingHost;

  /// Simpler arcs to try in place of an arc that shows a fault, the simplest first. Each is smaller
  /// in one respect and larger in none.
  static std::vector<Arc> smaller(const Params& p, const Arc& arc);
  /// "R^2 = 144 from (12, 0)"
  static std::string describe(const Params& p, const Arc& arc);
};

}  // namespace cosim::circular
