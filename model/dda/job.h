// What the DDA is given to do: a curve.
#pragma once

#include <string>
#include <vector>

#include "model/dda/checker.h"
#include "model/dda/drive.h"
#include "model/dda/view.h"

namespace cosim::dda {

/// Simpler jobs to try in place of a job that shows a fault, the simplest first. Each is smaller
/// in one respect and larger in none. Each of them ends.
std::vector<Job> smaller(const Params& p, const Job& job);
/// "rates (27, 9) from (0, 0), 27 and 9 steps"
std::string describe(const Params& p, const Job& job);

}  // namespace cosim::dda
