#include "tb/full/machine_of.h"

#include <algorithm>
#include <utility>

#include "model/core/input_error.h"
#include "tb/full/readable.h"

namespace cosim::cli {

const proof::BuiltMachine& machine_of(const AnyBench& bench) {
  for (const auto& machine : proof::built_machines()) {
    if (machine.title == bench.built_as()) return machine;
  }
  throw InputError(bench.title() + ": its RTL is not known");
}

const AnyBench& bench_of(const std::string& title) {
  return **std::ranges::find_if(benches(), [&](const auto& b) { return b->title() == title; });
}

proof::Source source_of(const AnyBench& bench) {
  proof::Source source = machine_of(bench).source;
  source.parameters = bench.parameters();
  return readable(std::move(source));
}

proof::Source source_for(const nets::Model& model, proof::Source source) {
  source.parameters = model.machine.parameters;
  return read_for(model.machine, readable(std::move(source)));
}

}  // namespace cosim::cli
