#include "tb/full/mutants_built.h"

#include <fmt/core.h>

#include <filesystem>
#include <sstream>
#include <utility>

#include "model/core/input_error.h"
#include "tb/full/machine_of.h"
#include "tb/program/chosen.h"
#include "tb/program/on_demand.h"
#include "tb/support/place.h"
#include "tb/support/quoted.h"

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

// A file that starts the program on a shape and so many mutants.
std::string started(const OnDemand& of_shape, const std::string& program, const std::string& shape,
                    std::uint64_t mutants) {
  const std::string file = fmt::format("{}_{}", of_shape.target, mutants);
  give(of_shape, file,
       fmt::format("#!/bin/sh\nexec {} {} {} \"$@\"\n", for_shell(program), for_shell(shape),
                   mutants));
  const std::filesystem::path path = std::filesystem::path(of_shape.folder) / file;
  std::filesystem::permissions(path, std::filesystem::perms::owner_exec,
                               std::filesystem::perm_options::add);
  return path.string();
}

}  // namespace

std::string built_mutants(const Registry& registry, const AnyBench& bench, std::uint64_t mutants) {
  const OnDemand& program = on_demand(registry.mutants(), bench.built_as());
  if (!machine_of(bench).streams) {
    build(registry, registry.attacks());
    return started(program, path_of(registry.attacks()), bench.built_as(), mutants);
  }
  give_rtl(program, bench, mutants);
  build(registry, program);
  return path_of(program);
}

Ended run_mutants(const std::string& program, const std::vector<std::string>& words) {
  std::vector<std::string> all{program};
  all.insert(all.end(), words.begin(), words.end());
  Ended ended = cosim::run_program(all);
  if (ended.status != 0 && ended.status != 1) {
    const std::string line = ended.text.substr(0, ended.text.find('\n'));
    throw InputError(fmt::format("{}: {}", std::filesystem::path(program).filename().string(),
                                 line.empty() ? "cannot be run" : line));
  }
  return ended;
}

Mutants mutants_of(const std::string& program) {
  std::istringstream lines(run_mutants(program, {"--about"}).text);
  Mutants all;
  std::getline(lines, all.of);
  if (!(lines >> all.count) || all.count == 0) {
    throw InputError(program + ": is no program that attacks mutants");
  }
  return all;
}

}  // namespace cosim::cli
