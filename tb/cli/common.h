// Options that several commands have.
#pragma once

#include <cstdint>
#include <string>

#include "tb/cli/command.h"
#include "tb/sim/mismatch.h"

namespace cosim::cli {

struct Common {
  Text csv;
  Text report;
  Text junit;
  Text checkpoint;
  Text seed_text;
  Text plot;
  Text wave, wave_before, wave_after;
  Text html;
  Text failures;
  bool keeps_failures = false;
  bool table = false;
  bool allows_nothing = false;  ///< a run that compares nothing is no error

  std::uint64_t seed() const;  ///< 1 where none was given
  Window window() const;       ///< of waves around a mismatch
  /// Where a mismatch leaves its folder: --failures, else $COSIM_FAILURES, else failures.
  std::string failures_folder() const;
};

/// --seed.
void add_seed(const Command& command, Common& common);
/// --allow-nothing-compared.
void add_allow_nothing(const Command& command, Common& common);
/// Both, and --report.
void add_common(const Command& command, Common& common);
/// --report.
void add_report(const Command& command, Common& common);
/// --csv, whose help is `rows`.
void add_csv(const Command& command, Common& common, const std::string& rows);
/// --failures; `kept`: failures are kept even without the option.
void add_failures(const Command& command, Common& common, bool kept = true);
/// --wave, whose help is `file`, and --html.
void add_wave(const Command& command, Common& common, const std::string& file);
/// --html, whose page has the verdict and `more`.
void add_html(const Command& command, Common& common, const std::string& more);
/// --wave-before and --wave-after.
void add_window(const Command& command, Common& common);
/// --plot.
void add_plot(const Command& command, Common& common);
/// All options that draw_one() uses; the help of --csv is `rows`.
void add_drawing(const Command& command, Common& common, const std::string& rows);

}  // namespace cosim::cli
