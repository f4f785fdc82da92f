// Nets as cells of at most three inputs, by abc.
#pragma once

#include <string>
#include <vector>

#include "tb/nets/blif.h"

namespace cosim::lanes {

/// The outputs in their order from the inputs in theirs. InputError, with `name`, where abc cannot
/// be run.
nets::Cells mapped(const std::string& name, const nets::Graph& graph,
                   const std::vector<nets::Bit>& inputs, const std::vector<nets::Bit>& outputs);

}  // namespace cosim::lanes
