// The bar of a sweep on a terminal, and nothing of it elsewhere.
// Needs: linear, circular
#include <gtest/gtest.h>

#include <csignal>
#include <string>

#include "tests/cli/program.h"

namespace cosim::cli {
namespace {

const Arguments kSweep{"sweep", "circular", "--exhaustive", "--width", "8"};

// What was drawn between one return to the line's start and the next, without the escape code that
// clears the rest of the line.
std::vector<std::string> drawn(const std::string& sent) {
  const std::string clear = "\x1b[K";
  std::vector<std::string> all;
  std::string line;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    if (sent[i] == '\r' || sent[i] == '\n') {
      all.push_back(line);
      line.clear();
    } else if (sent.compare(i, clear.size(), clear) == 0) {
      i += clear.size() - 1;
    } else {
      line += sent[i];
    }
  }
  all.push_back(line);
  return all;
}

TEST(Terminal, ShowsABar) {
  if (!has_terminals()) GTEST_SKIP() << "no pseudo-terminal can be had here";
  const Ended ended = cosim_on_terminal(kSweep, 200);
  EXPECT_EQ(ended.status, 0);
  int bars = 0, whole = 0;
  for (const std::string& line : drawn(ended.out)) {
    const std::size_t open = line.find(" % [");
    if (open == std::string::npos) continue;
    ++bars;
    EXPECT_EQ(line.find(']'), open + 4 + 30) << line;
    EXPECT_TRUE(has(line, "] circular W=8, every"));
    whole += line.find("100 % [##############################]") == 0 ? 1 : 0;
  }
  EXPECT_GE(bars, 2);
  EXPECT_GE(whole, 2);  // both sweeps come to their end; one may be shown there twice
  EXPECT_TRUE(has(ended.out, "verdict: match"));
}

// A single run that takes more than a moment; it leaves nothing of it.
TEST(Terminal, ShowsABarOfOneLongRun) {
  if (!has_terminals()) GTEST_SKIP() << "no pseudo-terminal can be had here";
  const Ended ended = cosim_on_terminal({"arc", "--radius", "30000000"}, 200);
  EXPECT_EQ(ended.status, 0);
  const std::vector<std::string> all = drawn(ended.out);
  int bars = 0;
  for (const std::string& line : all) bars += line.find(" % [") != std::string::npos ? 1 : 0;
  EXPECT_GE(bars, 2) << ended.out;
  expect_has(ended.out, {"] circular W=32", "\r\x1b[Kdrawn: "});
}

// Ten digits of the clock and of both coordinates, two signs: 38 bytes a step.
TEST(Terminal, SaysHowLargeACsvWillBe) {
  const Folder folder;
  const std::string csv = folder.path("c");
  const Ended large = cosim_signalled({"arc", "--radius", "4294967295", "--csv", csv}, SIGTERM,
                                      600'000, Until::a_line);
  EXPECT_TRUE(has(large.out, "csv: up to 231 GB, " + csv + "\n"));
  const Ended small = cosim({"line", "--major", "27", "--minor", "9", "--csv", csv});
  EXPECT_FALSE(has(small.out, "csv: "));
}

// The bar is gone once the sweep is over: in its place stands the plain line.
TEST(Terminal, IsLeftWithPlainLines) {
  if (!has_terminals()) GTEST_SKIP() << "no pseudo-terminal can be had here";
  const Ended ended = cosim_on_terminal(kSweep, 200);
  std::string screen;
  for (const std::string& line : lines(ended.out)) {  // each ends in \r\n
    const std::string text = line.substr(0, line.size() - 1);
    const std::size_t redrawn = text.rfind("\r\x1b[K");
    screen += (redrawn == std::string::npos ? text : text.substr(redrawn + 4)) + "\n";
  }
  EXPECT_FALSE(has(screen, "%"));
  EXPECT_FALSE(has(screen, "\r"));
  EXPECT_FALSE(has(screen, "\x1b"));
  EXPECT_EQ(lines(screen).size(), 4U) << screen;
}

TEST(Terminal, ThatIsNarrowHasABarThatFits) {
  if (!has_terminals()) GTEST_SKIP() << "no pseudo-terminal can be had here";
  const Ended ended = cosim_on_terminal(kSweep, 40);
  EXPECT_EQ(ended.status, 0);
  bool bar = false;
  for (const std::string& line : drawn(ended.out)) {
    if (line.find(" % [") == std::string::npos) continue;
    bar = true;
    EXPECT_LT(line.size(), 40U) << line;
  }
  EXPECT_TRUE(bar);
}

TEST(NoTerminal, HasPlainLinesAlone) {
  const Ended ended = ends(0, cosim(kSweep));
  EXPECT_FALSE(has(ended.out, "\r"));
  EXPECT_FALSE(has(ended.out, "\x1b"));
  EXPECT_FALSE(has(ended.out, "%"));
  EXPECT_EQ(lines(ended.out).size(), 4U)
      << ended.out;  // two sweeps, what was compared, the verdict
}

}  // namespace
}  // namespace cosim::cli
