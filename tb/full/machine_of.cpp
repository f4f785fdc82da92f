#include "tb/full/machine_of.h"

#include "model/core/input_error.h"
#include "tb/support/place.h"

namespace cosim::cli {

const proof::BuiltMachine& machine_of(const AnyBench& bench) {
  for (const auto& machine : proof::built_machines()) {
    if (machine.title == bench.built_as()) return machine;
  }
  throw InputError(bench.title() + ": its RTL is not known");
}

proof::Source source_of(const AnyBench& bench) {
  proof::Source source = machine_of(bench).source;
  source.parameters = bench.parameters();
  return source;
}

proof::Source source_for(const proof::MachineFormula& machine, proof::Source source) {
  source.asynchronous_reset = !machine.seen.empty();
  source.clocks_are_inputs = machine.clocks_are_inputs;
  source.parameters = machine.parameters;
  for (const proof::Wire& w : machine.registers) {
    if (w.field.index <= 0) source.kept.push_back(net_path(w.field.net).path);
  }
  return source;
}

}  // namespace cosim::cli
