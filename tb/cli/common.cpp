#include "tb/cli/common.h"

#include <fmt/core.h>

#include <cstdlib>

#include "model/core/input_error.h"

#include "tb/cli/number.h"
#include "tb/sim/failure.h"

namespace cosim::cli {

std::uint64_t Common::seed() const {
  return seed_text ? whole("--seed", *seed_text, 0, ~std::uint64_t{0}) : 1;
}

Window Common::window() const {
  constexpr std::uint64_t most = 1'000'000;
  Window window = wave_window;
  if (wave_before) window.before = whole("--wave-before", *wave_before, 0, most);
  if (wave_after) window.after = whole("--wave-after", *wave_after, 0, Mismatch::clocks_behind);
  return window;
}

std::string Common::failures_folder() const {
  if (failures) return *failures;
  const char* folder = std::getenv("COSIM_FAILURES");
  return folder != nullptr && *folder != '\0' ? folder : "failures";
}

void add_common(const Command& command, Common& common) {
  add_report(command, common);
  add_seed(command, common);
  add_allow_nothing(command, common);
}

void add_seed(const Command& command, Common& common) {
  command.text("--seed", common.seed_text, "S",
               "Seed of everything random, power-up states too; default 1");
}

void add_allow_nothing(const Command& command, Common& common) {
  command.flag("--allow-nothing-compared", common.allows_nothing,
               "A run that compares nothing is no error");
}

void add_report(const Command& command, Common& common) {
  command.text("--report", common.report, "FILE", "Write the verdict and the figures as JSON");
}

void add_csv(const Command& command, Common& common, const std::string& rows) {
  command.text("--csv", common.csv, "FILE", rows);
}

void add_failures(const Command& command, Common& common, bool kept) {
  common.keeps_failures = kept;
  command.text("--failures", common.failures, "DIR",
               kept ? "The folder of failures; default $COSIM_FAILURES or failures"
                    : "Leave a folder in DIR if it does not match");
  add_window(command, common);
}

void add_wave(const Command& command, Common& common, const std::string& file) {
  command.text("--wave", common.wave, "FILE.fst", file);
  add_html(command, common, "the wave");
}

void add_html(const Command& command, Common& common, const std::string& more) {
  command.text("--html", common.html, "FILE.html", "A page for a browser: the verdict and " + more);
}

void add_window(const Command& command, Common& common) {
  command.text("--wave-before", common.wave_before, "N",
               "Clocks that a wave shows before a mismatch; default 200");
  command.text("--wave-after", common.wave_after, "N",
               fmt::format("Clocks after it, 0 to {}; default 50", Mismatch::clocks_behind));
}

void add_plot(const Command& command, Common& common) {
  command.text("--plot", common.plot, "FILE",
               "Draw the path over the curve, and how far each step is off it: .svg or .png;\n"
               "a page of --html has it too");
}

void add_drawing(const Command& command, Common& common, const std::string& rows) {
  add_csv(command, common, rows);
  command.flag("--table", common.table, "Print every compared signal on every clock");
  add_plot(command, common);
  add_wave(command, common, "Draw the run as a waveform, with FILE.gtkw, its view for GTKWave");
  add_failures(command, common);
  add_common(command, common);
}

}  // namespace cosim::cli
