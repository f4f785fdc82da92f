// The subcommands of cosim. Each adds itself to the application; when it is chosen, `action` is set
// to what it does, which returns the exit status: 0 match, 1 mismatch. Bad input is an InputError.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "tb/mismatch.h"

namespace cosim::cli {

using Action = std::function<int()>;

/// The value of an option as typed; none where it was not given.
using Text = std::optional<std::string>;

/// Options that several commands have.
struct Common {
  Text csv;
  Text report;
  Text checkpoint;
  Text seed_text;
  Text plot;
  Text wave, wave_before, wave_after;
  Text failures;
  bool keeps_failures = false;
  bool table = false;

  std::uint64_t seed() const;  ///< 1 where none was given
  Window window() const;       ///< of waves around a mismatch
  /// Where a mismatch leaves its folder: --failures, else $COSIM_FAILURES, else failures.
  std::string failures_folder() const;
};

void add_list(CLI::App& app, Action& action);
void add_line(CLI::App& app, Action& action);
void add_arc(CLI::App& app, Action& action);
void add_dda(CLI::App& app, Action& action);
void add_path(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_sweep(CLI::App& app, Action& action);
void add_replay(CLI::App& app, Action& action);
void add_prove(CLI::App& app, Action& action);

/// An option, or without dashes a positional, whose help reads "name TYPE help". A value of no
/// characters is a value too.
CLI::Option* add_text(CLI::App& command, const std::string& name, Text& value,
                      const std::string& type, const std::string& help);
/// A switch.
void add_switch(CLI::App& command, const std::string& name, bool& value, const std::string& help);

/// The value; InputError "name: is needed" where there is none.
const std::string& needed(const std::string& name, const Text& value);

/// --report and --seed.
void add_common(CLI::App& command, Common& common);
/// --csv, whose help is `rows`.
void add_csv(CLI::App& command, Common& common, const std::string& rows);
/// --failures; `kept`: failures are kept without it, too.
void add_failures(CLI::App& command, Common& common, bool kept = true);
/// --wave, and what of it is drawn.
void add_wave(CLI::App& command, Common& common, const std::string& file);
/// --wave-before and --wave-after.
void add_window(CLI::App& command, Common& common);
/// --plot.
void add_plot(CLI::App& command, Common& common);
/// --table.
void add_table(CLI::App& command, Common& common);

}  // namespace cosim::cli
