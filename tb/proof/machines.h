// The formulas of every machine that is built.
#pragma once

#include "tb/proof/machine.h"
#include "tb/proof/rtl.h"

namespace cosim::proof {

/// A machine as a line of rtl/shipped.txt names it.
struct BuiltMachine {
  std::string title;
  MachineFormula (*formula)();  ///< null where the model is plain: no formula can be made of it
  Source source;                ///< the RTL it was built from
};

/// How the formula of a design at its parameters is made, for BuiltMachine.
template <class Trait>
constexpr auto formula_of() -> MachineFormula (*)() {
  using Design = typename Trait::Design;
  if constexpr (StepsOn<Design, Bits>) {
    return [] { return formula<Design>(Trait::params); };
  } else {
    return nullptr;
  }
}

/// All of them, in that file's order; made by CMake.
const std::vector<BuiltMachine>& built_machines();

}  // namespace cosim::proof
