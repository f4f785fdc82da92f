#include <fmt/format.h>

#include "tb/cli/command.h"
#include "tb/report.h"

namespace cosim::cli {

void add_list(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("list", "The designs and the widths that were built");
  command->callback([&action] {
    action = [] {
      std::string design;
      for (const auto& bench : benches()) {
        if (bench->design() != design) {
          design = bench->design();
          fmt::print("{} interpolator, {}: {} compared on every clock\n", design, bench->source(),
                     compared_signals(*bench));
        }
        fmt::print("  {}\n", bench->title());
      }
      return 0;
    };
  });
}

}  // namespace cosim::cli
