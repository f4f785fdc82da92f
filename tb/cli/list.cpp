#include <fmt/core.h>

#include <string>

#include "tb/cli/commands.h"
#include "tb/program/chosen.h"
#include "tb/report/report.h"

namespace cosim::cli {

void add_list(const Command& program) {
  const Command command = program.sub("list", "The designs that were built, and their parameters");
  command.action([] {
    for (const Unusable& unused : unusable()) leave_out(unused.why);
    std::string design;
    for (const auto& bench : benches()) {
      if (bench->design() != design) {
        design = bench->design();
        const std::string source = bench->source();
        fmt::print("{}{}: {} compared on every clock\n", design,
                   source.empty() ? "" : ", " + source, compared_signals(*bench));
      }
      fmt::print("  {}\n", bench->title());
    }
    return 0;
  });
}

}  // namespace cosim::cli
