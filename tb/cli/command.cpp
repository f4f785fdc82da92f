#include "tb/cli/command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

// The innermost command named: "sweep NAME" is at NAME.
const CLI::App& innermost(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : innermost(*chosen.back());
}

// "", "sweep: ", "sweep NAME: "
std::string prefix(const CLI::App& app) {
  std::string name;
  for (const CLI::App* one = &app; one->get_parent() != nullptr; one = one->get_parent()) {
    name = one->get_name() + (name.empty() ? "" : " ") + name;
  }
  return name.empty() ? name : name + ": ";
}

std::vector<const CLI::App*> subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string commands_of(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : subcommands(app)) {
    text += (text.empty() ? "" : ", ") + command->get_name();
  }
  return text;
}

// The words of a command that has more are designs.
const char* kind_of_words(const CLI::App& app) {
  return app.get_parent() == nullptr ? "command" : "design";
}

bool is_design(const CLI::App& program, const std::string& word) {
  return std::ranges::any_of(subcommands(program), [&](const CLI::App* command) {
    return std::ranges::any_of(subcommands(*command),
                               [&](const CLI::App* design) { return design->get_name() == word; });
  });
}

std::string unexpected(const CLI::App& app, const std::string& argument) {
  if (argument.starts_with('-')) {
    for (const CLI::App* design : subcommands(app)) {
      if (app.get_parent() == nullptr || design->get_option_no_throw(argument) == nullptr) continue;
      return fmt::format("{}{} comes behind the design: {} {} {}", prefix(app), argument,
                         app.get_name(), design->get_name(), argument);
    }
    return fmt::format("{}no such option: {}", prefix(app), in_quotes(argument));
  }
  const std::string commands = commands_of(app);
  if (commands.empty()) {
    const bool is_of_design = app.get_parent() != nullptr &&
                              app.get_parent()->get_parent() != nullptr &&
                              argument.find('=') != std::string::npos;
    return fmt::format("{}takes no {}{}", prefix(app), in_quotes(argument),
                       is_of_design ? ": it runs every configuration" : "");
  }
  if (app.get_parent() == nullptr && is_design(app, argument)) {
    return fmt::format("{} is a design: a command comes before it: {}", argument, commands);
  }
  // The program of the package has no designs.
  const bool is_of_package = app.get_parent() == nullptr &&
                             std::ranges::none_of(subcommands(app), [](const CLI::App* command) {
                               return command->get_name() == "sweep";
                             });
  return fmt::format("{}no such {}: {}; there are {}{}", prefix(app), kind_of_words(app),
                     in_quotes(argument), commands,
                     is_of_package ? "; the program of a project, build/NAME_cosim, has more" : "");
}

// The option that such an error begins with: "--minor: ...", "table ..." of a flag.
const CLI::Option* option_of(const CLI::App& at, const CLI::ArgumentMismatch& error) {
  std::string name = error.what();
  name.resize(std::min(name.find_first_of(": "), name.size()));
  if (!name.starts_with('-')) name.insert(0, "--");
  return at.get_option_no_throw(name);
}

std::string wrong_count(const CLI::Option& option) {
  const int most = option.get_items_expected_max();
  if (most == 0) return option.get_name() + ": takes no value";
  if (option.count() > static_cast<std::size_t>(most)) {
    return option.get_name() + ": is given more than once";
  }
  return option.get_name() + ": needs a value";
}

// One line for what the parser found wrong.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& at = innermost(app);
  if (const auto* mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    if (const CLI::Option* option = option_of(at, *mismatch)) return wrong_count(*option);
  }
  for (const CLI::App* one = &at; one != nullptr; one = one->get_parent()) {
    if (const auto rest = one->remaining(); !rest.empty()) return unexpected(*one, rest.front());
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    const std::string commands = commands_of(at);
    if (!commands.empty()) {
      return fmt::format("{}a {} is needed: {}", prefix(at), kind_of_words(at), commands);
    }
    for (const CLI::Option* option : at.get_options()) {
      if (option->get_required() && option->empty()) return option->get_name() + ": is needed";
    }
  }
  const std::string what = error.what();
  return what.substr(0, what.find('\n'));
}

// CLI11 takes "--name=" for an option without a value.
std::string empty_value(int argc, const char* const* argv) {
  for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    const std::string argument = argv[i];
    if (argument.starts_with("--") && argument.find('=') == argument.size() - 1) {
      return fmt::format("{}: needs a value", argument.substr(0, argument.size() - 1));
    }
  }
  return {};
}

// What may stand at the end of the command line that is typed behind --complete, a line each: the
// commands, and the options once a - is there. What is no command, a file or a design, is left out.
void print_completions(const CLI::App& program, int argc, const char* const* argv) {
  const CLI::App* at = &program;
  for (int i = 2; i + 1 < argc; ++i) {
    for (const CLI::App* command : subcommands(*at)) {
      if (command->get_name() != argv[i]) continue;
      at = command;
      break;
    }
  }
  const std::string_view begun = argc > 2 ? argv[argc - 1] : "";
  const auto offer = [&](const std::string& word) {
    if (word.starts_with(begun)) fmt::print("{}\n", word);
  };
  for (const CLI::App* command : subcommands(*at)) offer(command->get_name());
  if (!begun.starts_with('-')) return;
  for (const CLI::Option* option : at->get_options()) {
    for (const std::string& name : option->get_lnames()) offer("--" + name);
  }
}

// For bash: the program is asked itself.
void print_completion(const std::string& name) {
  fmt::print(
      "# Completion of {0} for bash: source <({0} --completion)\n"
      "_{0}_words() {{\n"
      "  mapfile -t COMPREPLY < <(\"$1\" --complete \"${{COMP_WORDS[@]:1:COMP_CWORD}}\" 2> "
      "/dev/null)\n"
      "}}\n"
      "complete -o default -F _{0}_words {0}\n",
      name);
}

}  // namespace

Command Command::sub(const std::string& name, const std::string& help) const {
  app_->require_subcommand(1);
  return {*app_->add_subcommand(name, help), *chosen_};
}

void Command::text(const std::string& name, Text& value, const std::string& type,
                   const std::string& help) const {
  const auto take = [&value, name](const std::string& text) {
    // CLI11 takes what follows, be it the next option. A file of such a name is ./--name.
    if (text.starts_with("--")) throw InputError(name + ": needs a value");
    value = text;
  };
  app_->add_option_function<std::string>(name, take, help)->type_name(type);
}

void Command::texts(const std::string& name, std::vector<std::string>& values,
                    const std::string& type, const std::string& help) const {
  app_->add_option(name, values, help)->type_name(type);
}

void Command::each(const std::string& name, std::vector<std::string>& values,
                   const std::string& type, const std::string& help) const {
  auto* option = app_->add_option(name, values, help + "; repeatable")->allow_extra_args(false);
  option->option_text(type);  // CLI11 adds dots, as for several in one place
}

void Command::argument(const std::string& name, Text& value, const std::string& help,
                       bool needed) const {
  const auto take = [&value](const std::string& text) { value = text; };
  app_->add_option_function<std::string>(name, take, help)->type_name("")->required(needed);
}

void Command::arguments(const std::string& name, std::vector<std::string>& values,
                        const std::string& help) const {
  // To CLI11 a name is one word; what stands behind it is text.
  const std::size_t space = name.find(' ');
  auto* option = app_->add_option(name.substr(0, space), values, help)->type_name("");
  if (space != std::string::npos) option->option_text(name.substr(space + 1));
}

void Command::flag(const std::string& name, bool& value, const std::string& help) const {
  app_->add_flag(name, value, help)->disable_flag_override();
}

void Command::footer(const std::string& text) const { app_->footer(text); }

void Command::action(Action action) const {
  app_->callback([chosen = chosen_, action = std::move(action)] { *chosen = action; });
}

int run_program(int argc, const char* const* argv, const std::string& name, const std::string& help,
                const std::function<void(const Command&)>& commands) {
  CLI::App app{help, name};
  app.get_formatter()->column_width(24);
  Action chosen;
  commands(Command(app, chosen));
  const std::string version = "cosim " COSIM_VERSION;
  app.set_version_flag("--version", name == "cosim" ? version : name + ", of " + version,
                       "Print the version and end");
  const auto completion = [&] {
    print_completion(name);
    throw CLI::Success();
  };
  app.add_flag_callback("--completion", completion, "Print the completion for bash and end");
  if (argc > 1 && std::string_view(argv[1]) == "--complete") {
    print_completions(app, argc, argv);
    return 0;
  }
  if (argc < 2) fmt::print("{}", app.help());
  if (const std::string line = empty_value(argc, argv); !line.empty()) throw InputError(line);
  std::vector<const char*> words(argv, argv + argc);
  if (argc > 1 && std::string_view(argv[1]) == "help") {  // help COMMAND is COMMAND --help
    words.erase(words.begin() + 1);
    words.push_back("--help");
  }
  try {
    app.parse(static_cast<int>(words.size()), words.data());
  } catch (const CLI::Success& call) {  // --help and the like
    return app.exit(call);
  } catch (const CLI::ParseError& error) {
    throw InputError(usage_error(app, error));
  }
  return chosen();
}

const std::string& needed(const std::string& name, const Text& value) {
  if (!value) throw InputError(name + ": is needed");
  return *value;
}

}  // namespace cosim::cli
