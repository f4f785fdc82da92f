#include "tests/careless/commands.h"

#include <array>
#include <cctype>
#include <cstdio>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace cosim::careless {
namespace {

std::string help_of(const std::string& program, const std::vector<std::string>& words) {
  std::string line = "'" + program + "'";
  for (const std::string& word : words) line += " " + word;
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((line + " --help").c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe && std::fgets(part.data(), part.size(), pipe.get()) != nullptr) text += part.data();
  if (text.empty()) throw std::runtime_error(line + " --help says nothing");
  return text;
}

std::vector<std::string> split(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// "  --csv FILE     Write ...": the value stands one blank behind the name.
Option option_of(const std::string& line) {
  const auto words = split(line);
  Option option{words.front(), "", line};
  const std::size_t behind = line.find(option.name) + option.name.size();
  const bool valued = line.size() > behind + 1 && line[behind] == ' ' && line[behind + 1] != ' ';
  if (valued) option.value = words[1];
  return option;
}

void add_commands(const std::string& program, const std::vector<std::string>& words,
                  std::vector<Command>& all) {
  Command command{words, {}, {}, {}, help_of(program, words)};
  std::vector<std::string> parts;
  std::istringstream lines(command.help);
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Example: cosim ")) command.example = split(line.substr(15));
    if (!line.starts_with("  ")) section = line;
    if (!line.starts_with("  ") || line[2] == ' ') {
      // More of what an option's help says.
      if (line.starts_with("    ") && !command.options.empty()) command.options.back().help += line;
      continue;
    }
    if (line[2] == '-') {
      command.options.push_back(option_of(line));
    } else if (section.starts_with("Positionals")) {
      command.positionals.push_back(split(line).front());
    } else if (section.find("ommands:") != std::string::npos) {
      parts.push_back(split(line).front());
    }
  }
  if (parts.empty()) all.push_back(command);
  for (const std::string& part : parts) {
    std::vector<std::string> inner = words;
    inner.push_back(part);
    add_commands(program, inner, all);
  }
}

}  // namespace

std::vector<Command> commands_of(const std::string& program) {
  std::vector<Command> all;
  add_commands(program, {}, all);
  std::size_t options = 0;
  for (const Command& command : all) options += command.options.size();
  if (all.size() < 2 || options < 2 * all.size()) {
    throw std::runtime_error("the help names hardly a command or option");
  }
  return all;
}

}  // namespace cosim::careless
