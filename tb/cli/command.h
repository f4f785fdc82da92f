// The subcommands of cosim. Each adds itself to the application; when it is chosen, `action` is set
// to what it does, which returns the exit status: 0 match, 1 mismatch. Bad input is an InputError.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

namespace cosim::cli {

using Action = std::function<int()>;

/// Options that several commands have.
struct Common {
  std::string csv;
  std::string report;
  std::string seed_text = "1";
  bool table = false;

  std::uint64_t seed() const;
};

void add_list(CLI::App& app, Action& action);
void add_line(CLI::App& app, Action& action);
void add_arc(CLI::App& app, Action& action);
void add_path(CLI::App& app, Action& action);
void add_sweep(CLI::App& app, Action& action);

/// --report and --seed.
void add_common(CLI::App& command, Common& common);
/// --csv, whose columns are `columns`.
void add_csv(CLI::App& command, Common& common, const std::string& columns);
/// --table.
void add_table(CLI::App& command, Common& common);

}  // namespace cosim::cli
