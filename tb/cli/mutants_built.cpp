#include "tb/cli/mutants_built.h"

#include <fmt/core.h>

#include <utility>

#include "tb/cli/chosen.h"
#include "tb/cli/on_demand.h"
#include "tb/support/place.h"

namespace cosim::cli {
namespace {

// What plant.sh is given of a machine.
void give_rtl(const OnDemand& program, const AnyBench& bench, std::uint64_t mutants) {
  give(program, "read.ys", proof::commands_to_elaborate(source_of(bench)) + '\n');
  give(program, "count.txt", fmt::format("{}\n", mutants));
  std::string kept, last;
  const auto fields = bench.compared();
  for (std::size_t i = 0; i < bench.registers(); ++i) {
    const std::string net = net_path(fields[i].net).path;
    if (net != std::exchange(last, net)) kept += net + '\n';
  }
  give(program, "kept.txt", kept);
}

}  // namespace

std::string built_mutants(const Registry& registry, const AnyBench& bench, std::uint64_t mutants) {
  const OnDemand& program = on_demand(registry.mutants(), bench.built_as());
  give_rtl(program, bench, mutants);
  build(registry, program);
  return path_of(program);
}

}  // namespace cosim::cli
