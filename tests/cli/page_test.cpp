// report.html and --html, as text. tests/cli/browser_test.sh opens them.
// Needs: linear, circular, toolpath
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.h"

namespace cosim::cli {
namespace {

using Page = InAFolder;

// One file that needs nothing else.
void expect_alone(const std::string& page) {
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_LT(page.size(), 1'000'000U);
  for (const char* other : {"<script", "http:", "https:", "@import", "url(h", "onload"}) {
    EXPECT_FALSE(has(page, other)) << other;
  }
  const std::string source = " src=\"";
  for (auto at = page.find(source); at != std::string::npos; at = page.find(source, at + 1)) {
    EXPECT_EQ(page.substr(at + source.size(), 11), "data:image/");
  }
}

TEST_F(Page, OfAFailureHasAllThatIsNeeded) {
  const Ended e = faulty({"line", "--major", "3000", "--minor", "700", "--failures",
                          folder.path("kept"), "--html", folder.path("x.html")});
  ASSERT_EQ(e.status, 1) << e.err;
  const std::string kept =
      "kept/" + fs::directory_iterator(folder.path("kept"))->path().filename().string();
  const std::string page = folder.text(kept + "/report.html");
  EXPECT_EQ(page, folder.text("x.html"));
  expect_alone(page);
  const auto report = nlohmann::json::parse(folder.text(kept + "/report.json"));
  const auto& mismatch = report.at("mismatch");
  const std::string signal = mismatch.at("signal");
  expect_has(page, {">MISMATCH<", ">linear M=32 N=26<", ">First difference: " + signal + '<',
                    "expected " + mismatch.at("expected").get<std::string>(),
                    "actual   " + mismatch.at("actual").get<std::string>()});
  for (const auto& name : report.at("compared_signals")) {
    EXPECT_TRUE(has(page, '>' + name.get<std::string>())) << name;
  }
  expect_has(page, {folder.text(kept + "/smallest.stim"), " replay " + folder.path(kept)});
}

TEST_F(Page, OfARunShowsItsWordsAndPath) {
  const Ended e = ends(0, cosim({"line", "--major", "27", "--minor", "9", "--code", "01010", "--m",
                                 "5", "--n", "2", "--html", folder.path("x.html")}));
  EXPECT_TRUE(has(e.out, "page: " + folder.path("x.html") + '\n'));
  const std::string page = folder.text("x.html");
  expect_alone(page);
  // Table 3 of the source: the words of the minor axis.
  expect_has(page, {">01000101<", ">01000100<", ">01000000<", ">match<", ">27<", ">9<"});
  EXPECT_TRUE(has(page, "to (27, 9)"));
  EXPECT_FALSE(has(page, "class=\"mark\""));
}

TEST_F(Page, OfASweepHasItsFiguresAndItsFailure) {
  const Arguments all =
      joined({"sweep", "linear", "--random", "20", "--m", "32", "--n", "26"},
             {"--failures", folder.path("kept"), "--html", folder.path("x.html")});
  ends(0, cosim(all));
  const std::string page = folder.text("x.html");
  expect_alone(page);
  expect_has(page, {">match<", ">linear M=32 N=26<", ">random lines: 20 cases, ",
                    "compared: 9 registers and 4 outputs on each of "});
  const Ended differs = faulty(all);
  ASSERT_EQ(differs.status, 1) << differs.err;
  const fs::path kept = fs::directory_iterator(folder.path("kept"))->path().filename();
  EXPECT_EQ(folder.text("x.html"), folder.text("kept/" + kept.string() + "/report.html"));
}

TEST_F(Page, OfSweepsHasALineForEach) {
  const Ended e =
      ends(0, cosim({"sweep", "circular", "--random", "20", "--html", folder.path("x.html")}));
  const std::string page = folder.text("x.html");
  expect_alone(page);
  EXPECT_TRUE(has(page, "<h1>circular</h1>"));
  std::size_t lines = 0;
  std::istringstream out(e.out);
  for (std::string line; std::getline(out, line);) {
    const std::size_t name = line.find(", random arcs: ");
    if (name == std::string::npos) continue;
    ++lines;
    const std::size_t figures = line.find(": ", name) + 2;
    EXPECT_TRUE(has(page, line.substr(0, name))) << line;
    EXPECT_TRUE(has(page, line.substr(figures, line.rfind(" (") - figures))) << line;
  }
  EXPECT_GT(lines, 1U);
}

TEST_F(Page, OfAPathHasAWaveAMachine) {
  const std::string program = folder.write("p.ngc", "G21 G90 G1 X1 Y0.5 F1\nG2 X2 Y-0.5 I0 J-1\n");
  ends(0, cosim({"path", program, "--steps-per-mm", "20", "--html", folder.path("x.html")}));
  const std::string page = folder.text("x.html");
  expect_has(page, {">The wave of linear ", ">The wave of circular "});
}

TEST_F(Page, OfALongRunSaysWhatItLeavesOut) {
  const Ended e = ends(0, cosim({"arc", "--radius", "3000", "--html", folder.path("x.html")}));
  const std::string page = folder.text("x.html");
  expect_alone(page);
  const std::size_t at = page.find("Shown: clocks 0 to ");
  ASSERT_NE(at, std::string::npos);
  unsigned last = 0, all = 0, after = 0;
  ASSERT_EQ(
      std::sscanf(page.c_str() + at, "Shown: clocks 0 to %u of %u clocks; left out: %u after them.",
                  &last, &all, &after),
      3);
  EXPECT_TRUE(has(e.out, " on each of " + std::to_string(all) + " clocks\n")) << e.out;
  EXPECT_EQ(last + 1 + after, all);
}

TEST_F(Page, ThatCannotBeWrittenIsSaidFirst) {
  const auto said = [&](const std::string& file) {
    const Ended e = cosim({"arc", "--radius", "5", "--html", file});
    EXPECT_EQ(e.out, "");
    return refusal(e);
  };
  EXPECT_EQ(said(""), "cosim: --html: names no file\n");
  EXPECT_EQ(said("x.htm"), "cosim: --html: x.htm does not end in .html\n");
  EXPECT_EQ(said(folder.path("none/x.html")),
            "cosim: " + folder.path("none/x.html") + ": cannot write: No such file or directory\n");
}

}  // namespace
}  // namespace cosim::cli
