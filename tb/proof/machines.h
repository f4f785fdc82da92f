// The golden models of every machine that is built, as nets, and their RTL.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/core/design.h"
#include "tb/nets/check_once.h"
#include "tb/nets/exported.h"
#include "tb/nets/jobs.h"
#include "tb/nets/played.h"
#include "tb/nets/same_model.h"
#include "tb/proof/yosys.h"

namespace cosim::proof {

/// A design at a shape.
struct BuiltMachine {
  std::string title;
  nets::Model (*nets)();     ///< makes its model; null where it cannot be made
  nets::Model (*covered)();  ///< the same with the ways through it
  Source source;             ///< the RTL it was built from
  bool streams = false;      ///< it has a stream model alone, without a step
  /// All that runs in lanes; null where there are no nets.
  nets::Played (*played)() = nullptr;
  /// What drives and checks its jobs; null where there are no nets.
  nets::Draw (*jobs)() = nullptr;
  bool resets_itself = false;  ///< a register of its RTL resets others without waiting for a clock

  /// Whether its RTL can be held against its model. The nets of what is reset at once show on the
  /// next step what they hold.
  bool is_provable() const { return nets != nullptr && !resets_itself; }
};

/// What the model of a machine is, for a person who asks why something cannot be done with it.
inline const char* kind_of_model(const BuiltMachine& machine) {
  if (machine.resets_itself) return "a register of its RTL resets others at once";
  return machine.streams ? "a stream model, which knows no clock"
                         : "a plain model, on machine integers alone";
}

/// Whether its model is a struct that an exporter wrote as a file.
template <class Design>
constexpr bool is_exported = requires(const typename Design::Params& p) {
  Design::file(p);
};

/// InputError where an exporter made another model of the struct.
template <class Trait>
void require_exported(const nets::Model& model) {
  using Design = typename Trait::Design;
  if constexpr (is_exported<Design>) {
    nets::check_once(Design::file(Trait::params), "clock",
                     [&] { nets::require_same<Design>(model, Trait::params, Trait::title); });
  }
}

/// That of a shape: Trait has Design, params and title. `source`: its RTL.
template <class Trait>
BuiltMachine built_machine(Source source) {
  using Design = typename Trait::Design;
  source.clocks_are_inputs = clocks_of<Design> != 0;
  if constexpr (requires { Trait::clocks; }) source.clocks_are_inputs |= *Trait::clocks != '\0';
  BuiltMachine machine{Trait::title, nullptr, nullptr, std::move(source), !StepsOn<Design, Word>};
  if constexpr (requires { Trait::resets; }) {
    machine.resets_itself = std::string_view(Trait::resets).find("inner ") != std::string::npos;
  }
  if constexpr (StepsOn<Design, nets::Number>) {
    machine.nets = [] {
      auto model = nets::model_of<Design>(Trait::params);
      require_exported<Trait>(model);
      return model;
    };
    machine.covered = [] { return nets::model_of<Design>(Trait::params, true); };
    machine.played = [] {
      auto played = nets::played_of<Design>(Trait::params);
      require_exported<Trait>(played.model);
      return played;
    };
    if constexpr (nets::DrivesOnNets<Design>) {
      machine.jobs = [] {
        auto draw = nets::draw_of_jobs<Design>(Trait::params);
        if constexpr (is_exported<Design>) {
          nets::check_once(Design::file(Trait::params), "jobs", [&] {
            nets::require_same_jobs<Design>(draw, Trait::params, Trait::title);
          });
        }
        return draw;
      };
    }
  }
  return machine;
}

/// All of them, in the order in which they were added; made by CMake.
const std::vector<BuiltMachine>& built_machines();

}  // namespace cosim::proof
