// The formulas of every machine that is built.
#pragma once

#include "tb/proof/machine.h"
#include "tb/proof/rtl.h"

namespace cosim::proof {

/// A machine as a line of rtl/shipped.txt names it.
struct BuiltMachine {
  std::string title;
  MachineFormula (*formula)();  ///< null where no formula can be made of the model
  Source source;                ///< the RTL it was built from
  bool streams = false;         ///< it has a stream model
};

/// Why there is no formula of a machine, for a person: what its model is.
inline const char* model_without_formula(const BuiltMachine& machine) {
  return machine.streams ? "a stream model, which knows no clock"
                         : "a plain model, on machine integers alone";
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
