// Verilog, as a front end of yosys makes cells of it.
#pragma once

#include <string>

#include "tb/equiv/side.h"

namespace cosim::equiv {

/// What a front end writes of a design.
struct Elaborated {
  std::string json, rtlil;
};

/// Reads the files. InputError, one line that begins with `what` or a file; OutOfTime.
Elaborated elaborated(const Files& files, const std::string& what, FrontEnd front_end,
                      const Budget& budget);

}  // namespace cosim::equiv
