#include "model/core/input_error.h"
#include "tb/cli/command.h"
#include "tb/cli/number.h"

namespace cosim::cli {

std::uint64_t Common::seed() const {
  return seed_text ? whole("--seed", *seed_text, 0, ~std::uint64_t{0}) : 1;
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

void add_table(CLI::App& command, Common& common) {
  add_switch(command, "--table", common.table, "Print every compared signal on every clock");
}

}  // namespace cosim::cli
