// What the program says of itself.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "tb/util/pattern.h"
#include "tests/cli/help.h"
#include "tests/cli/program.h"
#include "tests/support/root.h"

namespace cosim::cli {
namespace {

TEST(Help, FitsATerminal) {
  std::vector<Arguments> all = commands();
  all.insert(all.end(), {{}, {"sweep"}});
  for (const Arguments& command : all) {
    for (const std::string& line : lines(help(command))) {
      EXPECT_LE(line.size(), 100U) << name_of(command) << ": " << line;
    }
  }
}

// Of the commands of the harness; those of designs and studies have tests of their own.
TEST(Help, NamesEveryOption) {
  const std::map<std::string, std::vector<std::string>> options = {
      {"list", {"--help"}},
      {"new", {"NAME FILE...", "--plain"}},
      {"lint", {"MACHINE"}},
      {"wave",
       {"WHAT", "--hostile CLOCKS", "--out FILE.fst", "--seed S", "--failures DIR",
        "--wave-before N", "--wave-after N"}},
      {"examples", {"--help"}},
      {"replay",
       {"FILE", "--wave FILE.fst", "--html FILE.html", "--failures DIR", "--wave-before N",
        "--wave-after N", "--report FILE", "--allow-nothing-compared"}},
      {"prove",
       {"MACHINE", "--rtl DIR", "--limit S", "--jobs J", "--keep DIR", "--theorems", "--mutants N",
        "--count N", "--mutant K", "--failures DIR"}}};
  expect_in(help({}), {"0 match, 1 mismatch, 2 bad input"});
  for (const auto& [command, words] : options) expect_in(help({command}), words);
  const std::vector<Arguments> sweeps = commands({"sweep"});
  EXPECT_FALSE(sweeps.empty());
  for (const Arguments& sweep : sweeps) {
    expect_in(help(sweep),
              {"--exhaustive", "--random COUNT", "--hostile COUNT", "--jobs J", "--checkpoint FILE",
               "--report FILE", "--seed S", "--allow-nothing-compared"});
  }
}

TEST(Help, HasAVersion) {
  const Ended ended = ends(0, cosim({"--version"}));
  EXPECT_TRUE(ended.out.starts_with("cosim 1.")) << ended.out;
  EXPECT_TRUE(has(ended.out, "(Verilator 5."));
  EXPECT_EQ(lines(ended.out).size(), 1U);
}

// What bash offers behind these words.
std::vector<std::string> completed(const std::string& typed) {
  const Folder folder;
  const std::string script = folder.write(
      "typed", "source <(" COSIM_PROGRAM " --completion)\nCOMP_WORDS=(cosim " + typed +
                   ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
                   "_cosim_words " COSIM_PROGRAM "\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
  EXPECT_EQ(std::system(("bash '" + script + "' > '" + folder.path("offered") + '\'').c_str()), 0);
  return lines(folder.text("offered"));
}

TEST(Completion, OffersEveryCommandAndOptionOfTheHelp) {
  std::vector<std::string> names;
  for (const Arguments& command : commands()) {
    if (names.empty() || names.back() != command.front()) names.push_back(command.front());
  }
  EXPECT_EQ(completed("''"), names);
  EXPECT_EQ(completed("repl"), (std::vector<std::string>{"replay"}));
  // A line of the help each, "  --wave FILE", the first with a letter before it.
  const std::string text = help({"replay"});
  const Pattern option("\n +(?:-[a-z],)?(--[a-z-]+)");
  std::vector<std::string> options;
  for (const auto& found : option.all(text)) options.push_back(found[1]);
  EXPECT_GE(options.size(), 7U);
  EXPECT_EQ(completed("replay --"), options);
  EXPECT_EQ(completed("replay --wave-b"), (std::vector<std::string>{"--wave-before"}));
}

TEST(Help, ComesWithoutACommandToo) {
  const Ended ended = ends(2, cosim({}));
  EXPECT_EQ(ended.out, help({}));
}

// The example of a command's help runs as it stands, but for its files.
void expect_example_runs(const Arguments& command) {
  const Folder folder;
  Arguments words = example_of(command, folder);
  if (command.front() == "prove") {
    words.insert(words.end(), {"--rtl", (test::project_root() / "rtl").string()});
  }
  const Ended ended = cosim(words);
  // Of one shape few clocks do not reach every bit: that is a verdict too.
  const bool covers = command.front() == "cover";
  EXPECT_TRUE(ended.status == 0 || (covers && ended.status == 1)) << ended.err << name_of(words);
  EXPECT_EQ(ended.err, "") << name_of(words);
}

TEST(Help, HasExamplesThatRun) {
  for (const Arguments& command : commands()) {
    // Two have no arguments, the others tests of their own; the files of "equiv" are its user's.
    const std::string& name = command.front();
    if (name == "list" || name == "examples" || name == "prove" || name == "new" ||
        name == "equiv") {
      continue;
    }
    expect_example_runs(command);
  }
}

TEST(Help, HasAProofThatRuns) {
  if (std::system("{ command -v yosys; } > /dev/null") != 0) {
    GTEST_SKIP() << "needs yosys";
  }
  expect_example_runs({"prove"});
}

// What scripts/cosim runs without arguments: a title, then the command.
TEST(Examples, AreCommandsThatRun) {
  const Ended ended = ends(0, cosim({"examples"}));
  const std::vector<std::string> all = lines(ended.out);
  ASSERT_FALSE(all.empty());
  const std::string start = "  cosim ";
  for (std::size_t i = 0; i < all.size(); i += 2) {
    ASSERT_FALSE(all[i].starts_with(' ')) << all[i];
    ASSERT_LT(i + 1, all.size());
    ASSERT_TRUE(all[i + 1].starts_with(start)) << all[i + 1];
    Arguments words;
    std::istringstream text(all[i + 1].substr(start.size()));
    for (std::string word; text >> word;) {
      words.push_back(word.starts_with("tests/") ? (test::project_root() / word).string() : word);
    }
    EXPECT_EQ(cosim(words).status, 0) << all[i + 1];
  }
}

TEST(List, NamesAllThatIsShipped) {
  const Ended ended = ends(0, cosim({"list"}));
  std::vector<std::string> machines, shipped;
  for (const std::string& line : lines(ended.out)) {
    if (line.starts_with("  ")) machines.push_back(line.substr(2));
  }
  std::ifstream file(test::project_root() / "rtl/shipped.txt");
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line.front() != '#') shipped.push_back(line);
  }
  EXPECT_EQ(machines, shipped);
  EXPECT_FALSE(shipped.empty());
}

}  // namespace
}  // namespace cosim::cli
