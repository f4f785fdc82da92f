// How this room runs other programs: cosim_rtl and `cosim new` each have a way of their own.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace cosim::rtl {

struct Ran {
  int status = 0;    ///< 127 where there is no such program
  std::string text;  ///< what it printed, errors included
};

/// Runs a program, found as a shell finds it, with nothing to read.
using Run = std::function<Ran(const std::vector<std::string>& words)>;

}  // namespace cosim::rtl
