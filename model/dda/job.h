// What the DDA is given to do: a curve.
#pragma once

#include <string>
#include <vector>

#include "model/dda/curve.h"

namespace cosim::dda {

/// How many clocks shift its rates.
int shifts_of(int width, const Job& job);

/// Simpler jobs to try in place of a job that shows a fault, the simplest first. Each is smaller
/// in one respect and larger in none. Each of them ends.
std::vector<Job> smaller(const Job& job);
/// "rates (27, 9) from (0, 0), 27 and 9 steps"
std::string describe(const Job& job);

}  // namespace cosim::dda
