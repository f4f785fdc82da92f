// What a build folder makes when a command needs it.
#pragma once

#include <string>
#include <vector>

namespace cosim {

/// Builds these in the build folder by that CMake; one process at a time. InputError where that
/// fails, with what a compiler said on standard error.
void build_targets(const std::string& cmake, const std::string& folder,
                   const std::vector<std::string>& targets);

}  // namespace cosim
