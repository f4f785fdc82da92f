// PROGRAM list and PROGRAM examples: what there is to run.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>

#include "tb/cli/chosen.h"
#include "tb/cli/commands.h"
#include "tb/cli/registry.h"
#include "tb/sim/report.h"
#include "tb/util/words.h"

namespace cosim::cli {

void add_list(const Command& program) {
  const Command command = program.sub("list", "The designs that were built, and their parameters");
  auto drawn = std::make_shared<bool>(false);
  command.flag("--drawn", *drawn, "Print how random transactions of stream models are distributed");
  command.action([drawn] {
    for (const Unusable& unused : unusable()) leave_out(unused.why);
    std::string design;
    for (const auto& bench : benches()) {
      if (bench->design() != design) {
        design = bench->design();
        const std::string source = bench->source();
        std::vector<const AnyBench*> shapes;
        for (const auto& other : benches()) {
          if (other->design() == design) shapes.push_back(other.get());
        }
        fmt::print("{}{}: {} compared on every clock\n", design,
                   source.empty() ? "" : ", " + source, compared_signals(shapes));
      }
      fmt::print("  {}\n", bench->title());
      if (*drawn) fmt::print("{}", bench->drawn_text(1));
    }
    return 0;
  });
}

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
