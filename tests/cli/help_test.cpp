// What the program says of itself.
#include <gtest/gtest.h>

#include <algorithm>

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

TEST(Help, FitsATerminal) {
  for (const Arguments& command :
       {Arguments{}, Arguments{"list"}, Arguments{"line"}, Arguments{"arc"}, Arguments{"path"},
        Arguments{"dda"}, Arguments{"compare"}, Arguments{"sweep"}, Arguments{"sweep", "linear"},
        Arguments{"sweep", "circular"}, Arguments{"sweep", "dda"}}) {
    for (const std::string& line : lines(help(command))) EXPECT_LE(line.size(), 100U) << line;
  }
}

TEST(Help, NamesEveryOption) {
  expect_in(help({}), {"list", "line", "arc", "dda", "path", "compare", "sweep",
                       "0 match, 1 mismatch, 2 bad input"});
  expect_in(help({"line"}), {"--major BP", "--minor MP", "--code UK", "--m M", "--n N",
                             "--csv FILE", "tick,major,minor", "--report FILE", "--seed S"});
  expect_in(help({"arc"}), {"--from X,Y", "--radius R", "--radius2 Q", "--count K", "--width W",
                            "--csv FILE", "clock,dx,dy,x,y", "--report FILE", "--seed S"});
  expect_in(help({"path"}), {"FILE", "--steps-per-mm S", "--csv FILE", "segment,dx,dy,x,y",
                             "--report FILE", "--seed S"});
  expect_in(help({"dda"}),
            {"--line X,Y", "--circle R", "--conic A,B,C,D,E,F", "--from X,Y", "--clocks N",
             "--update HOW", "--preload S", "--as-it-is", "--width W"});
  expect_in(help({"compare"}), {"FILE", "--steps-per-mm S", "--line BP,MP", "--arc R",
                                "--algorithms LIST", "--report FILE"});
  for (const char* design : {"linear", "circular", "dda"}) {
    expect_in(help({"sweep", design}),
              {"--exhaustive", "--random COUNT", "--hostile COUNT", "--jobs J", "--checkpoint FILE",
               "--report FILE", "--seed S"});
  }
}

TEST(Help, ComesWithoutACommandToo) {
  const Ended ended = cosim({});
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.out, help({}));
}

// The examples of the help run as they stand.
TEST(Help, HasExamplesThatRun) {
  for (const Arguments& command :
       {Arguments{"line"}, Arguments{"arc"}, Arguments{"dda"}, Arguments{"compare"},
        Arguments{"sweep", "linear"}, Arguments{"sweep", "circular"}, Arguments{"sweep", "dda"}}) {
    const std::string text = help(command);
    const std::string start = "Example: cosim ";
    const std::size_t at = text.find(start);
    ASSERT_NE(at, std::string::npos) << text;
    Arguments words;
    std::istringstream example(
        text.substr(at + start.size(), text.find('\n', at) - at - start.size()));
    for (std::string word; example >> word;) words.push_back(word);
    const auto file = std::find(words.begin(), words.end(), "--csv");
    const Folder folder;
    if (file != words.end()) file[1] = folder.path(file[1]);
    EXPECT_EQ(cosim(words).status, 0) << text;
  }
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
