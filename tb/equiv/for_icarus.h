// What Icarus Verilog 11 misreads, in words that it does not.
#pragma once

#include <string>

namespace cosim::equiv {

/// A text of Verilog that means the same, on the same lines:
///   s[2:0] that is all of a signed variable   it counts and selects as signed: braces around it
///   q <<= n                                   n is cut to the width of q: q = q << n
///   'shf                                      is as wide as its digits: 32'shf
std::string for_icarus(const std::string& text);

}  // namespace cosim::equiv
