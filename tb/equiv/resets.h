// The inputs that reset the RTLs.
#pragma once

#include "tb/equiv/equiv.h"

namespace cosim::equiv {

/// Finds them, once the gates of both are made, and puts them into the question; where there is
/// none `reset_clocks` becomes 0. Each input that resets a register asynchronously is one. Without
/// such an input it is the one that is called rst, reset, clr or clear and leaves the most
/// registers at constants; of several clocks it is each that leaves more of them so.
/// `wanted_resets` come in place of what would be found.
void find_resets(Question& question);

}  // namespace cosim::equiv
