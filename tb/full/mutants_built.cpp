#include "tb/full/mutants_built.h"

#include <fmt/core.h>

#include <filesystem>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/full/machine_of.h"
#include "tb/sim/failure.h"
#include "tb/util/output_file.h"
#include "tb/util/quoted.h"

namespace cosim::cli {

namespace fs = std::filesystem;

std::string built_mutants(const Registry& registry, const AnyBench& bench, std::uint64_t mutants) {
  const OnDemand& attacks = registry.attacks();
  const fs::path written = source_of(bench).written;
  const std::string option = written.empty() ? "" : " --written " + for_shell(written.string());
  build(registry, {attacks});
  const fs::path folder = fs::path(attacks.folder) / "mutants";
  fs::create_directories(folder);
  const fs::path file = folder / failure_name(bench, fmt::format("{} mutants", mutants));
  write_file(file.string(),
             fmt::format("#!/bin/sh\nexec {} {} {}{} \"$@\"\n", for_shell(path_of(attacks)),
                         for_shell(bench.built_as()), mutants, option));
  fs::permissions(file, fs::perms::owner_exec, fs::perm_options::add);
  return file.string();
}

Ended run_mutants(const std::string& program, const std::vector<std::string>& words) {
  std::vector<std::string> all{program};
  all.insert(all.end(), words.begin(), words.end());
  Ended ended = cosim::run_program(all);
  if (ended.status != 0 && ended.status != 1) {
    const std::string line = ended.text.substr(0, ended.text.find('\n'));
    throw InputError(fmt::format("{}: {}", fs::path(program).filename().string(),
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
