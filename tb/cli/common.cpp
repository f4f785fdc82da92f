#include <fmt/format.h>

#include <cstdlib>

#include "model/core/input_error.h"
#include "tb/cli/command.h"
#include "tb/cli/number.h"
#include "tb/failure.h"

namespace cosim::cli {

std::uint64_t Common::seed() const {
  return seed_text ? whole("--seed", *seed_text, 0, ~std::uint64_t{0}) : 1;
}

Window Common::window() const {
  constexpr std::uint64_t most = 1'000'000;
  Window window = FailureOptions{}.wave;
  if (wave_before) window.before = whole("--wave-before", *wave_before, 0, most);
  if (wave_after) window.after = whole("--wave-after", *wave_after, 0, Mismatch::clocks_behind);
  return window;
}

std::string Common::failures_folder() const {
  if (failures) return *failures;
  const char* folder = std::getenv("COSIM_FAILURES");
  return folder != nullptr && *folder != '\0' ? folder : "failures";
}

CLI::Option* add_text(CLI::App& command, const std::string& name, Text& value,
                      const std::string& type, const std::string& help) {
  const auto take = [&value, name](const std::string& text) {
    // CLI11 takes what follows, be it the next option. A file of such a name is ./--name.
    if (name.starts_with("--") && text.starts_with("--")) {
      throw InputError(name + ": needs a value");
    }
    value = text;
  };
  return command.add_option_function<std::string>(name, take, help)->type_name(type);
}

void add_switch(CLI::App& command, const std::string& name, bool& value, const std::string& help) {
  command.add_flag(name, value, help)->disable_flag_override();
}

const std::string& needed(const std::string& name, const Text& value) {
  if (!value) throw InputError(name + ": is needed");
  return *value;
}

void add_common(CLI::App& command, Common& common) {
  add_text(command, "--report", common.report, "FILE", "Write the verdict and the figures as JSON");
  add_text(command, "--seed", common.seed_text, "S",
           "Seed of everything random, power-up states too; default 1");
}

void add_csv(CLI::App& command, Common& common, const std::string& rows) {
  add_text(command, "--csv", common.csv, "FILE", rows);
}

void add_failures(CLI::App& command, Common& common, bool kept) {
  common.keeps_failures = kept;
  add_text(command, "--failures", common.failures, "DIR",
           kept ? "Where a mismatch leaves its folder; default $COSIM_FAILURES or failures"
                : "Leave a folder in DIR where it does not match");
  add_window(command, common);
}

void add_wave(CLI::App& command, Common& common, const std::string& file) {
  add_text(command, "--wave", common.wave, "FILE.fst", file);
}

void add_window(CLI::App& command, Common& common) {
  add_text(command, "--wave-before", common.wave_before, "N",
           "Clocks that a wave shows before a mismatch; default 200");
  add_text(command, "--wave-after", common.wave_after, "N",
           fmt::format("and behind it, 0 to {}; default 50", Mismatch::clocks_behind));
}

void add_plot(CLI::App& command, Common& common) {
  add_text(command, "--plot", common.plot, "FILE",
           "Draw the path over the curve, and how far each step is off it: .svg or .png");
}

void add_table(CLI::App& command, Common& common) {
  add_switch(command, "--table", common.table, "Print every compared signal on every clock");
}

}  // namespace cosim::cli
