// The small form of a program: for what it has not it becomes the full one.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "model/core/input_error.h"
#include "tb/cli/full.h"
#include "tb/cli/registry.h"

namespace cosim::cli {
namespace {

bool is_full(std::string_view word) {
  return std::ranges::any_of(full_commands,
                             [&](const FullCommand& command) { return command.name == word; });
}

[[noreturn]] void run_full(const Registry& registry) {
  const std::string path = path_of(registry.full());
  execv(path.c_str(), command_line());
  throw InputError(path + ": cannot be run");
}

// `besides`: built with it, for both to be there sooner.
void become_full_with(const Registry& registry, std::vector<OnDemand> besides) {
  if (isatty(STDERR_FILENO) != 0 && !std::filesystem::exists(path_of(registry.full()))) {
    fmt::print(stderr, "Building what this needs, once\n");
  }
  besides.insert(besides.begin(), registry.full());
  build(registry, besides);
  run_full(registry);
}
void become_full(const Registry& registry) { become_full_with(registry, {}); }

void hand_over(const Registry& registry) {
  char** argv = command_line();
  if (argv[0] == nullptr || argv[1] == nullptr) return;
  if (argv[1] == std::string_view("mutate") && argv[2] != nullptr && argv[2][0] != '-') {
    become_full_with(registry, {registry.attacks()});
  }
  if (is_full(argv[1])) become_full(registry);
  // A shell completes what is typed: nothing is built for that.
  const bool completes = std::string_view(argv[1]) == "--complete" && argv[2] != nullptr;
  if (completes && is_full(argv[2]) && std::filesystem::exists(path_of(registry.full()))) {
    run_full(registry);
  }
}

void add_commands(const Command& program, const Registry& registry) {
  for (const FullCommand& command : full_commands) {
    if (command.name != std::string_view("mutate") || registry.has_designs()) {
      program.sub(command.name, command.help);
    }
  }
}

Sweep in_lanes(const AnyBench&, const Sweep& sweep, std::uint64_t, std::uint64_t, const Text&) {
  return sweep;  // become_full() came first
}

coverage::Answers ask_points(const coverage::Asking&, coverage::Points&) { return {}; }

}  // namespace
}  // namespace cosim::cli

int main(int argc, char** argv) {
  using namespace cosim::cli;
  return run_form(argc, argv, {hand_over, add_commands, become_full, in_lanes, ask_points});
}
