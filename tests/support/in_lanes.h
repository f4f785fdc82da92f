// The lanes of a built design, kept in the build folder for the program and all tests.
#pragma once

#include <utility>

#include "tb/lanes/jobs.h"
#include "tb/lanes/sweep.h"
#include "tb/proof/machines.h"

namespace cosim::test {

/// The machine of a bench, and its RTL.
inline std::pair<const proof::BuiltMachine*, proof::Source> machine_of(const AnyBench& bench) {
  for (const auto& machine : proof::built_machines()) {
    if (machine.title != bench.title()) continue;
    proof::Source source = machine.source;
    source.parameters = bench.parameters();
    return {&machine, source};
  }
  throw std::logic_error(bench.title() + ": no machine");
}

inline std::unique_ptr<lanes::Built> in_lanes(const AnyBench& bench, int lanes) {
  const auto [machine, source] = machine_of(bench);
  return lanes::built(machine->title, machine->played(), source, lanes, COSIM_LANES_FOLDER);
}

/// For jobs.
inline std::unique_ptr<lanes::Built> jobs_in_lanes(const AnyBench& bench, int lanes) {
  const auto [machine, source] = machine_of(bench);
  nets::Played played = machine->played();
  played.draw = machine->jobs();
  return lanes::built(machine->title, played, source, lanes, COSIM_LANES_FOLDER);
}

}  // namespace cosim::test
