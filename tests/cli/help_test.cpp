// What the program says of itself.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/cli/folder.h"
#include "tests/cli/program.h"
#include "tests/support/root.h"

namespace cosim::cli {
namespace {

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

// Every command that has no commands of its own, as the help of those above it names them.
std::vector<Arguments> commands(const Arguments& above = {}) {
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

TEST(Help, FitsATerminal) {
  std::vector<Arguments> all = commands();
  all.insert(all.end(), {{}, {"sweep"}});
  for (const Arguments& command : all) {
    for (const std::string& line : lines(help(command))) {
      EXPECT_LE(line.size(), 100U) << name_of(command) << ": " << line;
    }
  }
}

TEST(Help, NamesEveryOption) {
  const std::vector<std::string> sweep = {"--exhaustive", "--random COUNT",    "--hostile COUNT",
                                          "--jobs J",     "--checkpoint FILE", "--report FILE",
                                          "--seed S"};
  const std::map<std::string, std::vector<std::string>> options = {
      {"list", {"--help"}},
      {"line",
       {"--major BP", "--minor MP", "--code UK", "--m M", "--n N", "--csv FILE", "tick,major,minor",
        "--report FILE", "--seed S"}},
      {"arc",
       {"--from X,Y", "--radius R", "--radius2 Q", "--count K", "--width W", "--csv FILE",
        "clock,dx,dy,x,y", "--report FILE", "--seed S"}},
      {"dda",
       {"--line X,Y", "--circle R", "--conic A,B,C,D,E,F", "--from X,Y", "--clocks N",
        "--update HOW", "--preload S", "--as-it-is", "--width W"}},
      {"path",
       {"FILE", "--steps-per-mm S", "--csv FILE", "segment,dx,dy,x,y", "--report FILE",
        "--seed S"}},
      {"compare",
       {"FILE", "--steps-per-mm S", "--line BP,MP", "--arc R", "--algorithms LIST",
        "--report FILE"}},
      {"sweep linear", sweep},
      {"sweep circular", sweep},
      {"sweep dda", sweep},
      {"replay",
       {"FILE", "--wave FILE.fst", "--failures DIR", "--wave-before N", "--wave-after N",
        "--report FILE"}},
      {"prove",
       {"MACHINE", "--rtl DIR", "--limit S", "--jobs J", "--scripts DIR", "--theorems",
        "--mutants FILE.v", "--count N", "--mutant K", "--failures DIR"}}};
  expect_in(help({}), {"0 match, 1 mismatch, 2 bad input"});
  std::set<std::string> named;
  for (const Arguments& command : commands()) {
    const std::string name = name_of(command);
    named.insert(name);
    ASSERT_TRUE(options.contains(name)) << name << " is not looked at here";
    expect_in(help(command), options.at(name));
  }
  EXPECT_EQ(named.size(), options.size()) << "the help does not name all";
}

TEST(Help, OfTheScriptNamesEveryCommand) {
  std::ifstream file(test::project_root() / "scripts/cosim");
  std::string text;
  for (std::string line; std::getline(file, line) && line.starts_with('#');) text += line + '\n';
  for (const Arguments& command : commands()) {
    const std::regex word("\\b" + command.front() + "\\b[,;]");
    EXPECT_TRUE(std::regex_search(text, word)) << command.front() << " is not in:\n" << text;
  }
}

TEST(Help, ComesWithoutACommandToo) {
  const Ended ended = cosim({});
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.out, help({}));
}

// The example of a command's help runs as it stands, but for its files.
void expect_example_runs(const Arguments& command) {
  const std::string text = help(command);
  const std::string start = "Example: cosim ";
  const std::size_t at = text.find(start);
  ASSERT_NE(at, std::string::npos) << text;
  Arguments words;
  std::istringstream example(
      text.substr(at + start.size(), text.find('\n', at) - at - start.size()));
  for (std::string word; example >> word;) words.push_back(word);

  const Folder folder;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] == "--csv" || words[i] == "--wave") words[i + 1] = folder.path(words[i + 1]);
  }
  const std::filesystem::path root = test::project_root();
  const std::map<std::string, std::string> files = {
      {"path", "tests/toolpaths/flange.ngc"},
      {"replay", "tests/regressions/carry_round_the_accumulator.stim"}};
  const auto file = files.find(command.front());
  if (file != files.end()) words[1] = (root / file->second).string();
  if (command.front() == "prove") words.insert(words.end(), {"--rtl", (root / "rtl").string()});
  const Ended ended = cosim(words);
  EXPECT_EQ(ended.status, 0) << ended.err << text;
}

TEST(Help, HasExamplesThatRun) {
  for (const Arguments& command : commands()) {
    // The one has no arguments, the other a test of its own.
    if (command.front() != "list" && command.front() != "prove") expect_example_runs(command);
  }
}

TEST(Help, HasAProofThatRuns) {
  if (std::system("{ command -v yosys && command -v cvc5 && command -v z3; } > /dev/null") != 0) {
    GTEST_SKIP() << "needs yosys, cvc5 and z3";
  }
  expect_example_runs({"prove"});
}

TEST(List, NamesAllThatIsShipped) {
  const Ended ended = cosim({"list"});
  EXPECT_EQ(ended.status, 0);
  std::vector<std::string> machines, shipped;
  for (const std::string& line : lines(ended.out)) {
    if (line.starts_with("  ")) machines.push_back(line.substr(2));
  }
  std::ifstream file(test::project_root() / "rtl/shipped.txt");
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line.front() != '#') shipped.push_back(line);
  }
  EXPECT_EQ(machines, shipped);
  EXPECT_EQ(shipped.size(), 17U);
}

}  // namespace
}  // namespace cosim::cli
