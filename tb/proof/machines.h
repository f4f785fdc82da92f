// The formulas of every machine that is built.
#pragma once

#include "tb/proof/machine.h"
#include "tb/proof/rtl.h"

namespace cosim::proof {

/// A machine as a line of rtl/shipped.txt names it.
struct BuiltMachine {
  std::string title;
  MachineFormula (*formula)();
  Source source;  ///< the RTL it was built from
};

/// All of them, in that file's order; made by CMake.
const std::vector<BuiltMachine>& built_machines();

}  // namespace cosim::proof
