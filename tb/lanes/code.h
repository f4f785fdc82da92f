// From a design's nets to the code of its lanes.
#pragma once

#include "tb/lanes/text.h"
#include "tb/nets/played.h"
#include "tb/proof/rtl_nets.h"

namespace cosim::lanes {

/// InputError where the RTL is not what the model's tables say, or cannot run in lanes.
Code code_of(const nets::Played& played, const proof::RtlNets& rtl);

}  // namespace cosim::lanes
