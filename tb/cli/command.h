// The commands of a program and their options. The library that reads the command line is hidden in
// command.cpp: its header takes longer to compile than all the rest of a command.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cosim::cli {

/// What a command does; it returns the exit status: 0 match, 1 mismatch. Bad input is an
/// InputError.
using Action = std::function<int()>;

/// The value of an option as typed; none where it was not given.
using Text = std::optional<std::string>;

/// One command of a program, or the program itself. A handle: copies stand for the same command.
/// The variables that options write to must live until the command's action has ended.
class Command {
 public:
  /// A command below this one. If there are several, the user has to name one.
  Command sub(const std::string& name, const std::string& help) const;

  /// An option "--name" with a value, whose help reads "--name TYPE help". The value may be empty.
  void text(const std::string& name, Text& value, const std::string& type,
            const std::string& help) const;
  /// An option that takes one value or more, and may be given again.
  void texts(const std::string& name, std::vector<std::string>& values, const std::string& type,
             const std::string& help) const;
  /// An option that takes one value, and may be given again: its help says so.
  void each(const std::string& name, std::vector<std::string>& values, const std::string& type,
            const std::string& help) const;
  /// A word without a name. InputError "NAME: is needed" if it is `needed` and missing.
  void argument(const std::string& name, Text& value, const std::string& help,
                bool needed = false) const;
  /// All words without a name.
  void arguments(const std::string& name, std::vector<std::string>& values,
                 const std::string& help) const;
  /// An option without a value.
  void flag(const std::string& name, bool& value, const std::string& help) const;
  /// Lines under the help.
  void footer(const std::string& text) const;
  void action(Action action) const;

 private:
  friend int run_program(int, const char* const*, const std::string&, const std::string&,
                         const std::function<void(const Command&)>&);
  Command(CLI::App& app, Action& chosen) : app_(&app), chosen_(&chosen) {}
  CLI::App* app_;
  Action* chosen_;
};

/// Reads the command line of the program `name`, whose help begins with `help`, runs the command
/// and returns the exit status. `commands` adds the commands. InputError, one line, for a command
/// line that cannot be read; without any argument the help is printed first. --version and
/// --completion, for bash, are there without being added.
int run_program(int argc, const char* const* argv, const std::string& name, const std::string& help,
                const std::function<void(const Command&)>& commands);

/// The value; InputError "name: is needed" where there is none.
const std::string& needed(const std::string& name, const Text& value);

}  // namespace cosim::cli
