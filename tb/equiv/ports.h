// Whether the ports of both sides fit each other and the options.
#pragma once

#include "tb/equiv/equiv.h"

namespace cosim::equiv {

/// InputError where an option names a port that is not there, where the sides have other ports or
/// widths than the options explain, or where their clocks have other edges.
void require_ports(const Question& q);

/// InputError for what has no meaning where there are several clocks.
void require_steps(const Question& q);

}  // namespace cosim::equiv
