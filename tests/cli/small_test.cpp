// The small form of the program: what it does itself and what it becomes the full one for look the
// same.
// Needs: circular
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "tests/cli/program.h"

namespace cosim::cli {
namespace {

void expect_the_same(const Arguments& arguments) {
  std::string shown;
  for (const std::string& a : arguments) shown += a + " ";
  SCOPED_TRACE(shown);
  const Ended small = small_cosim(arguments), full = cosim(arguments);
  EXPECT_EQ(small.status, full.status);
  EXPECT_EQ(small.out, full.out);
  EXPECT_EQ(small.err, full.err);
}

TEST(SmallProgram, SaysWhatTheFullOneSays) {
  for (const char* word : {"--help", "list", "examples", "draw", "prove --help", "--complete p",
                           "--complete prove --en"}) {
    Arguments words;
    for (std::string rest = word; !rest.empty();) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      words.push_back(rest.substr(0, end));
      rest.erase(0, end + 1);
    }
    expect_the_same(words);
  }
  EXPECT_NE(cosim({"--complete", "prove", "--en"}).out, "");
}

// Of what only the full one has, the file that it writes shows that it ran.
TEST(SmallProgram, BecomesTheFullOne) {
  const Folder folder;
  const std::string report = folder.path("report.json");
  ends(0, small_cosim({"sweep", "circular", "--width", "4", "--hostile", "300000", "--lanes", "64",
                       "--report", report}));
  EXPECT_TRUE(std::filesystem::exists(report));
  expect_the_same({"prove", "no_such_design"});
  expect_the_same({"new"});
  expect_the_same({"equiv", "--gold", "no_such_file.v"});
  expect_the_same({"regress", "no_such_plan.json"});
}

// It reads its own command line first: what cannot be run is refused without the full one.
TEST(SmallProgram, RefusesLanesThatThereAreNot) {
  expect_the_same({"sweep", "circular", "--hostile", "10", "--lanes", "7"});
}

}  // namespace
}  // namespace cosim::cli
