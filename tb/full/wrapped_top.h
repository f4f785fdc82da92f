// The wrapper that `cosim new` and `cosim equiv` write around a top.
#pragma once

#include <string>
#include <vector>

#include "tb/new/found.h"
#include "tb/new/new_sources.h"

namespace cosim::cli {

/// Whether the top has ports that are interfaces, or one of `words` gives it a type.
bool needs_wrapper(const std::vector<std::string>& words, const Sources& rtl);

/// Adds a wrapper, the new top, to the files where a value of `words`, as of --param, is
/// SystemVerilog, or where a port is an interface. Gives the parameters of the shape. `asked`: the
/// folder that has the files, and the options. InputError, one line.
std::vector<FoundParameter> with_wrapper(const std::string& name,
                                         const std::vector<std::string>& words, Sources& rtl,
                                         const RtlQuestion& asked);

}  // namespace cosim::cli
