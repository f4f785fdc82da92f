// What SU 1665343 claims of its machine.
#pragma once

#include "tb/proof/theorems.h"

namespace cosim::circular {

/// On integers without end: every radius and every width.
std::vector<proof::Theorem> circle_theorems();
/// From the pins to the first point: every shipped width.
std::vector<proof::Theorem> arc_theorems();

}  // namespace cosim::circular
