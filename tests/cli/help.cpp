#include "tests/cli/help.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tb/util/read_file.h"
#include "tests/support/root.h"

namespace cosim::cli {
namespace {

// A stored stimulus of a machine that is built.
std::string stored_stimulus() {
  const std::string built = ends(0, cosim({"list"})).out;
  for (const auto& file :
       std::filesystem::directory_iterator(test::project_root() / "tests/regressions")) {
    const std::vector<std::string> text = lines(read_file(file.path().string()));
    const std::string machine = "machine ";
    if (text.at(1).starts_with(machine) &&
        built.find("  " + text[1].substr(machine.size()) + '\n') != std::string::npos)
      return file.path().string();
  }
  ADD_FAILURE() << "no stimulus is stored of a machine that is built";
  return "";
}

}  // namespace

std::string help(Arguments command) {
  command.push_back("--help");
  const Ended ended = cosim(command);
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err, "");
  return ended.out;
}

void expect_in(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    EXPECT_NE(text.find(word), std::string::npos) << word << " is not in:\n" << text;
  }
}

std::vector<Arguments> commands(const Arguments& above) {
  std::vector<Arguments> all;
  bool listed = false;
  for (const std::string& line : lines(help(above))) {
    if (line == "Subcommands:") {
      listed = true;
    } else if (listed && line.starts_with("  ") && line[2] != ' ') {
      Arguments command = above;
      command.push_back(line.substr(2, line.find(' ', 2) - 2));
      for (const Arguments& one : commands(command)) all.push_back(one);
    } else if (line.empty()) {
      listed = false;
    }
  }
  if (all.empty()) all.push_back(above);
  return all;
}

std::string name_of(const Arguments& command) {
  std::string name;
  for (const std::string& word : command) name += (name.empty() ? "" : " ") + word;
  return name;
}

std::string names_of_commands(const Arguments& above) {
  std::string names;
  for (const Arguments& command : commands(above)) {
    const std::string& name = command.at(above.size());
    if ((", " + names + ",").find(", " + name + ",") != std::string::npos) continue;
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

std::vector<Arguments> commands_with(const std::string& option) {
  std::vector<Arguments> all = commands();
  std::erase_if(all, [&](const Arguments& c) { return help(c).find(option) == std::string::npos; });
  return all;
}

Arguments example_of(const Arguments& command, const Folder& folder) {
  const std::string text = help(command);
  const std::string start = "Example: cosim ";
  const std::size_t at = text.find(start);
  EXPECT_NE(at, std::string::npos) << text;
  if (at == std::string::npos) return command;
  const std::filesystem::path tests = test::project_root() / "tests";
  Arguments words;
  std::istringstream example(
      text.substr(at + start.size(), text.find('\n', at) - at - start.size()));
  for (std::string word; example >> word;) {
    if (word.ends_with(".ngc")) word = (tests / "toolpaths/flange.ngc").string();
    if (word.ends_with(".stim")) word = stored_stimulus();
    const bool written = !words.empty() && (words.back() == "--csv" || words.back() == "--wave" ||
                                            words.back() == "--out");
    words.push_back(written ? folder.path(word) : word);
  }
  return words;
}

}  // namespace cosim::cli
