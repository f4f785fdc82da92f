// What the circular machine is given to do, SU 1665343: an arc.
#pragma once

#include <string>
#include <vector>

#include "model/circular/checker.h"
#include "model/circular/drive.h"
#include "model/circular/view.h"

namespace cosim::circular {

/// Simpler arcs to try in place of an arc that shows a fault, the simplest first. Each is smaller
/// in one respect and larger in none.
std::vector<Arc> smaller(const Params& p, const Arc& arc);
/// "R^2 = 144 from (12, 0)"
std::string describe(const Params& p, const Arc& arc);

}  // namespace cosim::circular
