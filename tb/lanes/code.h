// From a design's nets to the code of its lanes.
#pragma once

#include <string>
#include <vector>

#include "tb/lanes/text.h"
#include "tb/nets/blif.h"
#include "tb/nets/played.h"
#include "tb/proof/rtl_nets.h"

namespace cosim::lanes {

/// InputError where the RTL is not what the model's tables say, or cannot run in lanes.
Code code_of(const nets::Played& played, const proof::RtlNets& rtl);

/// Nets as cells of at most three inputs, by abc: the outputs in their order from the inputs in
/// theirs. InputError, with `name`, where abc cannot be run.
nets::Cells mapped(const std::string& name, const nets::Graph& graph,
                   const std::vector<nets::Bit>& inputs, const std::vector<nets::Bit>& outputs);

}  // namespace cosim::lanes
