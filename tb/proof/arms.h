// Whether two codes differ, as a solver finds it out soonest.
#pragma once

#include "tb/proof/expression.h"
#include "tb/proof/rtl.h"

namespace cosim::proof {

/// Of two codes of the same width; what `rtl` defines is looked through.
Expression differ(const Expression& a, const Expression& b, const Rtl& rtl);

}  // namespace cosim::proof
