// What yosys finds in RTL at one set of its parameters.
#pragma once

#include <string>
#include <vector>

#include "tb/cli/found.h"

namespace cosim::cli {

/// `top`: the top module, "" where yosys is to find it; `parameters`: options of yosys' hierarchy,
/// as " -chparam W 5". Sizes follow no parameter yet, and a reset is found only where it is
/// asynchronous. InputError as of found_in().
Found found_at(const std::vector<std::string>& files, const std::string& top,
               const std::string& parameters, bool with_registers);

}  // namespace cosim::cli
