// --plot: a picture is drawn, or one line says why not. What it shows: picture_test.cpp.
// Needs: linear, circular
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/cli/help.h"
#include "tests/cli/picture.h"
#include "tests/support/stand_ins.h"

namespace cosim::cli {
namespace {

// The example of each command that draws a picture, without the files it writes.
std::vector<Arguments> drawings() {
  const Folder unused;
  std::vector<Arguments> all;
  for (const Arguments& command : commands_with("--plot FILE")) {
    Arguments words = example_of(command, unused);
    const auto csv = std::find(words.begin(), words.end(), "--csv");
    if (csv != words.end()) words.erase(csv, csv + 2);
    // A path of 60 000 steps would take its time.
    const auto scale = std::find(words.begin(), words.end(), "--steps-per-mm");
    if (scale != words.end()) *(scale + 1) = "1";
    all.push_back(words);
  }
  EXPECT_FALSE(all.empty());
  return all;
}

TEST(Plot, DrawsEitherFormat) {
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  for (const Arguments& plain : drawings()) {
    const Folder folder;
    for (const char* name : {"a.svg", "a.png"}) {
      const Ended ended = ends(0, cosim(joined(plain, {"--plot", folder.path(name)})));
      EXPECT_EQ(ended.out, cosim(plain).out);
    }
    EXPECT_EQ(folder.text("a.png").substr(1, 3), "PNG");
    EXPECT_TRUE(has(folder.text("a.svg"), "<svg"));
    EXPECT_TRUE(has(folder.text("a.svg"), "step along the path"));
  }
}

void expect_no_plot(const std::string& file, const std::string& error) {
  for (const Arguments& arguments : drawings()) {
    const Ended ended = cosim(joined(arguments, {"--plot", file}));
    EXPECT_EQ(ended.out, "") << arguments.front();
    EXPECT_EQ(refusal(ended), "cosim: " + error + "\n") << arguments.front();
  }
}

TEST(Plot, RefusesWhatItCannotDraw) {
  expect_no_plot("a.pdf", "--plot: a.pdf does not end in .svg or .png");
  expect_no_plot("png", "--plot: png does not end in .svg or .png");
  expect_no_plot(".png", "--plot: '.png' has no name before its .png");
  const Arguments twice{"arc", "--radius", "12", "--csv", "/tmp/a.png", "--plot", "/tmp/a.png"};
  EXPECT_EQ(refusal(cosim(twice)), "cosim: --plot: /tmp/a.png is the file of --csv\n");
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  expect_no_plot("/nowhere/a.png", "/nowhere/a.png: cannot write: No such file or directory");
}

TEST(Plot, RefusesAPathTooLongToDraw) {
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  const Folder folder;
  const Ended ended =
      cosim({"line", "--major", "4294967295", "--minor", "0", "--plot", folder.path("a.svg")});
  EXPECT_EQ(refusal(ended),
            "cosim: --plot: a path of more than 999999 steps is too long to draw\n");
  EXPECT_FALSE(folder.holds("a.svg"));
}

TEST(Plot, SaysThatGnuplotIsMissing) {
  const Folder folder;
  const test::WithPath none(folder.path("empty"));
  expect_no_plot(folder.path("a.png"),
                 "--plot: needs gnuplot, which is not installed (apt-get install gnuplot-nox)");
  EXPECT_FALSE(folder.holds("a.png"));
}

}  // namespace
}  // namespace cosim::cli
