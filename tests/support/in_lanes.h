// The lanes of a built design, kept in the build folder for the program and all tests.
#pragma once

#include "tb/lanes/sweep.h"
#include "tb/proof/machines.h"

namespace cosim::test {

inline std::unique_ptr<lanes::Built> in_lanes(const AnyBench& bench, int lanes) {
  for (const auto& machine : proof::built_machines()) {
    if (machine.title != bench.title()) continue;
    proof::Source source = machine.source;
    source.parameters = bench.parameters();
    return lanes::built(machine.title, machine.played(), source, lanes, COSIM_LANES_FOLDER);
  }
  throw std::logic_error(bench.title() + ": no machine");
}

}  // namespace cosim::test
