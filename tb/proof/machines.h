// The formulas and nets of every machine that is built.
#pragma once

#include "tb/nets/played.h"
#include "tb/proof/machine.h"
#include "tb/proof/rtl.h"

namespace cosim::proof {

/// A machine as a line of rtl/shipped.txt names it.
struct BuiltMachine {
  std::string title;
  /// How its model is made; null where no formula can be made of it.
  MachineFormula (*formula)();
  nets::Model (*nets)();
  Source source;         ///< the RTL it was built from
  bool streams = false;  ///< it has a stream model
  /// All that runs in lanes; null where there are no nets.
  nets::Played (*played)() = nullptr;
};

/// Why there is no formula of a machine, for a person: what its model is.
inline const char* model_without_formula(const BuiltMachine& machine) {
  return machine.streams ? "a stream model, which knows no clock"
                         : "a plain model, on machine integers alone";
};

/// How the formula and the nets of a design at its parameters are made, for BuiltMachine.
template <class Trait>
constexpr auto formula_of() -> MachineFormula (*)() {
  using Design = typename Trait::Design;
  if constexpr (StepsOn<Design, Bits>) {
    return [] { return formula<Design>(Trait::params); };
  } else {
    return nullptr;
  }
}
template <class Trait>
constexpr auto nets_of() -> nets::Model (*)() {
  using Design = typename Trait::Design;
  if constexpr (StepsOn<Design, nets::Number>) {
    return [] { return nets::model_of<Design>(Trait::params); };
  } else {
    return nullptr;
  }
}

template <class Trait>
constexpr auto played_of() -> nets::Played (*)() {
  using Design = typename Trait::Design;
  if constexpr (StepsOn<Design, nets::Number>) {
    return [] { return nets::played_of<Design>(Trait::params); };
  } else {
    return nullptr;
  }
}

/// All of them, in that file's order; made by CMake.
const std::vector<BuiltMachine>& built_machines();

}  // namespace cosim::proof
