// The formulas of every machine that is built.
#pragma once

#include "tb/proof/machine.h"

namespace cosim::proof {

/// A machine as a line of rtl/shipped.txt names it.
struct BuiltMachine {
  std::string title;
  MachineFormula (*formula)();
};

/// All of them, in that file's order; made by CMake.
const std::vector<BuiltMachine>& built_machines();

}  // namespace cosim::proof
