// z3, for the theorems: scripts of SMT-LIB 2.
#pragma once

#include <string>

#include "tb/proof/answer.h"

namespace cosim::proof {

/// Has z3 answer all that a script asks, in `limit` seconds of processor time at the most.
Solved solve_by_z3(const std::string& script, int limit);

}  // namespace cosim::proof
