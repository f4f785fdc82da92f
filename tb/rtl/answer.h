// What CMake asks of RTL: the words of the program cosim_rtl.
#pragma once

#include <string>
#include <vector>

namespace cosim::rtl {

/// Prints the answer. Status: 0 it has; 2 the words ask nothing, or the RTL cannot be read, with a
/// line that says why.
int answer(const std::vector<std::string>& words);

}  // namespace cosim::rtl
