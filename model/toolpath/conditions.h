// Codes that leave the path alone beside some words and not beside others, or only on some
// controls.
#pragma once

#include <string_view>

#include "model/toolpath/block.h"

namespace cosim::toolpath {

/// InputError, with the word's place, for a block whose words give one of its codes a meaning that
/// may change the path:
///  - axis words beside G4, G50, G50.1, G92.1, G92.2 and, of X Y I J R, M codes of takes_arguments:
///    a move to one control, an argument to another;
///  - G5 and G5.1 save as the modes of a high-speed control, `G5 P0`, `G5 P10000`, `G5.1 Q0` and
///    `G5.1 Q1`, which hold the path within their tolerance: other words make them splines, or run
///    data from elsewhere;
///  - `G54 P5`, `G15 H5`: another coordinate system. P beside G54 is that of G64 where it is no
///    whole number, H beside G15 that of G43;
///  - G70 and G71 with P, Q, U, W or D: turning cycles;
///  - K other than 0, or without an arc; E without G187, L without G10.
///
/// With no motion mode active X or U beside G4 can only be a time.
void check_conditions(const Block& block, std::string_view name, bool motion_mode);

}  // namespace cosim::toolpath
