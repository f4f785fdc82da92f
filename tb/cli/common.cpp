#include <fmt/format.h>

#include <algorithm>

#include "tb/cli/command.h"
#include "tb/cli/conclude.h"
#include "tb/cli/number.h"

namespace cosim::cli {

std::uint64_t Common::seed() const {
  return whole("--seed", seed_text, 0, ~std::uint64_t{0});
}

void add_common(CLI::App& command, Common& common) {
  command.add_option("--report", common.report, "Write a report to FILE, JSON")->type_name("FILE");
  command.add_option("--seed", common.seed_text,
                     "Seed of everything random, power-up states too; default 1")
      ->type_name("S");
}

void add_csv(CLI::App& command, Common& common, const std::string& columns) {
  command.add_option("--csv", common.csv, "Write " + columns + " to FILE")->type_name("FILE");
}

void add_table(CLI::App& command, Common& common) {
  command.add_flag("--table", common.table, "Print every compared signal on every clock");
}

int conclude(const std::vector<Outcome>& outcomes, const Common& common, const std::string& extra) {
  write_report(common.report, report_json(outcomes, common.seed(), extra));
  for (const Outcome& o : outcomes) {
    fmt::print("  compared {} on each of {} clocks\n", compared_signals(*o.bench), o.result.clocks);
    fmt::print("  drawn    {} steps, at most {:.3f} steps off\n", o.result.checked.steps,
               o.result.checked.max_deviation);
  }
  fmt::print("{}", verdict_text(outcomes));
  return std::all_of(outcomes.begin(), outcomes.end(),
                     [](const Outcome& o) { return o.result.match(); })
             ? 0
             : 1;
}

}  // namespace cosim::cli
