// The formulas and nets of every machine that is built.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/core/stream.h"
#include "tb/nets/jobs.h"
#include "tb/nets/played.h"
#include "tb/proof/machine.h"
#include "tb/proof/rtl.h"

namespace cosim::proof {

/// A design at a shape.
struct BuiltMachine {
  std::string title;
  /// How its model is made; null where no formula can be made of it.
  MachineFormula (*formula)();
  nets::Model (*nets)();
  Source source;         ///< the RTL it was built from
  bool streams = false;  ///< it has a stream model alone, without a step
  /// All that runs in lanes; null where there are no nets.
  nets::Played (*played)() = nullptr;
  /// What drives and checks its jobs; null where there are no nets.
  nets::Draw (*jobs)() = nullptr;
  bool resets_itself = false;  ///< a register of its RTL resets others without waiting for a clock
};

/// Why there is no formula of a machine, for a person: what its model is.
inline const char* model_without_formula(const BuiltMachine& machine) {
  if (machine.resets_itself) return "a register of its RTL resets others at once";
  return machine.streams ? "a stream model, which knows no clock"
                         : "a plain model, on machine integers alone";
};

/// That of a shape: Trait has Design, params and title. `source`: its RTL.
template <class Trait>
BuiltMachine built_machine(Source source) {
  using Design = typename Trait::Design;
  source.clocks_are_inputs = clocks_of<Design> != 0;
  if constexpr (requires { Trait::clocks; }) source.clocks_are_inputs |= *Trait::clocks != '\0';
  BuiltMachine machine{Trait::title, nullptr, nullptr, std::move(source),
                       HasStreams<Design> && !StepsOn<Design, Word>};
  if constexpr (requires { Trait::resets; }) {
    machine.resets_itself = std::string_view(Trait::resets).find("inner ") != std::string::npos;
  }
  // The nets of what is reset so show on the next step what they hold.
  if (machine.resets_itself) {
    machine.formula = nullptr;
  } else if constexpr (StepsOn<Design, Bits>) {
    machine.formula = [] { return formula<Design>(Trait::params); };
  }
  if constexpr (StepsOn<Design, nets::Number>) {
    machine.nets = [] { return nets::model_of<Design>(Trait::params); };
    machine.played = [] { return nets::played_of<Design>(Trait::params); };
    if constexpr (nets::DrivesOnNets<Design>) {
      machine.jobs = [] { return nets::draw_of_jobs<Design>(Trait::params); };
    }
  }
  return machine;
}

/// All of them, in the order in which they were added; made by CMake.
const std::vector<BuiltMachine>& built_machines();

}  // namespace cosim::proof
