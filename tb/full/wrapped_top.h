// The wrapper that `cosim new` writes around a top.
#pragma once

#include <string>
#include <vector>

#include "tb/new/found.h"
#include "tb/new/new_sources.h"

namespace cosim::cli {

/// Adds a wrapper, the new top, to the files where a value of `words`, as of --param, is
/// SystemVerilog, or where a port is an interface. Gives the parameters of the shape. `asked`: the
/// folder that has the files, and the options. InputError, one line.
std::vector<FoundParameter> with_wrapper(const std::string& name,
                                         const std::vector<std::string>& words, Sources& rtl,
                                         const RtlQuestion& asked);

}  // namespace cosim::cli
