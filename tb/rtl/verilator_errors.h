// What an error of Verilator means to who has the RTL.
#pragma once

#include <string>

namespace cosim::rtl {

/// The first error in the text, in words that say where it is and what to do; Verilator's own after
/// `otherwise` where it is no known one.
std::string error_in(const std::string& text, const std::string& otherwise);

}  // namespace cosim::rtl
