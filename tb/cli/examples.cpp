#include <fmt/core.h>
#include <fmt/ranges.h>

#include "tb/cli/commands.h"
#include "tb/program/registry.h"
#include "tb/support/words.h"

namespace cosim::cli {

void add_examples(const Command& program, const Registry& registry) {
  if (registry.examples().empty()) return;
  const Command command =
      program.sub("examples", "Command lines to begin with, for each design and study");
  command.action([&registry] {
    for (const Example& example : registry.examples()) {
      fmt::print("{}\n  {} {}\n", example.title, program_name(), fmt::join(example.words, " "));
    }
    return 0;
  });
}

}  // namespace cosim::cli
