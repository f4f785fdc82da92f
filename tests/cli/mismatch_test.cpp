// A mismatch from end to end, on benches that go wrong on clock 20 (faulty_benches.cpp).
// Needs: linear, circular, toolpath
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace cosim::cli {
namespace {

using nlohmann::json;

struct Found {
  Ended ended;
  json report;
  std::vector<std::string> csv;
};

// Runs a command that must end in a mismatch on clock `clock`.
Found find(Arguments command, std::uint64_t clock, const std::string& signal) {
  const Folder folder;
  const bool writes_csv = command.front() != "sweep";
  if (writes_csv) command.insert(command.end(), {"--csv", folder.path("csv")});
  Found f;
  f.ended = faulty(
      joined(command, {"--report", folder.path("report"), "--failures", folder.path("failures")}));
  EXPECT_EQ(f.ended.status, 1);
  EXPECT_EQ(f.ended.err, "");
  expect_has(f.ended.out, {"\nverdict: MISMATCH\n",
                           "first difference: clock " + std::to_string(clock) + ", " + signal});
  const std::string elsewhere = std::filesystem::temp_directory_path().string();
  for (const std::string& line : lines(f.ended.out)) {
    // What names a file is as long as the way to it.
    if (line.find(elsewhere) != std::string::npos) continue;
    EXPECT_LE(line.size(), 120U) << line;
  }
  EXPECT_TRUE(has(f.ended.out, "\nkept in: " + folder.path("failures")));
  f.report = json::parse(folder.text("report"), nullptr, false);
  EXPECT_EQ(f.report["verdict"], "mismatch");
  EXPECT_EQ(f.report["mismatch"]["clock"], clock);
  EXPECT_EQ(f.report["mismatch"]["signal"], signal);
  if (writes_csv) f.csv = lines(folder.text("csv"));
  return f;
}

TEST(Mismatch, OfALine) {
  const Found f = find({"line", "--major", "3000", "--minor", "700"}, 20, "counter4");
  EXPECT_EQ(f.report["clocks"], 21);
  EXPECT_NE(f.report["mismatch"]["expected"], f.report["mismatch"]["actual"]);
  // The words seen before: BP, UK, start and the first word formed take four clocks.
  EXPECT_EQ(f.csv.size(), 1U + 20 - 4);
  EXPECT_EQ(f.report["steps"], 64 * 16);
  EXPECT_TRUE(has(f.ended.out, "1024 steps before the first difference\n"));
}

// Eight clocks before and four behind, each signal on each of them, all within 120 columns.
TEST(Mismatch, ShowsTheClocksAroundInATable) {
  const Found f = find({"line", "--major", "3000", "--minor", "700"}, 20, "counter4");
  std::vector<std::string> clocks;
  std::size_t registers = 0, parts = 0;
  for (const std::string& line : lines(f.ended.out)) {
    std::istringstream cells(line);
    std::string head;
    cells >> head;
    if (head == "clock") {
      ++parts;
      for (std::string cell; cells >> cell;) clocks.push_back(cell);
    }
    registers += head == "reg" ? 1 : 0;
  }
  EXPECT_EQ(clocks, (std::vector<std::string>{"12", "13", "14", "15", "16", "17", "18", "19", ">20",
                                              "21", "22", "23", "24"}));
  EXPECT_GT(parts, 1U);              // words of 64 bits do not fit otherwise
  EXPECT_EQ(registers, parts * 10);  // nine, one of them twice
}

TEST(Mismatch, OfAnArc) {
  const Found f = find({"arc", "--radius", "100000"}, 20, "ct7");
  EXPECT_EQ(f.csv.size(), 1U + 20 - 1);  // the load takes a clock
}

TEST(Mismatch, OfAPathNamesTheSegment) {
  const Folder folder;
  // Three clocks and the word and the end each: the line of 200 is on the machine on clock 20.
  const std::string file = folder.write("p.ngc", "G0 X5\n(between)\nX100\nG3 X0 Y100 I-100\n");
  const Found f = find({"path", file, "--steps-per-mm", "20"}, 20, "counter4");
  EXPECT_EQ(f.report["mismatch"]["case"], "segment 2, line 3 of the program");
  EXPECT_TRUE(has(f.ended.out, "segment 2, line 3 of the program\n"));
}

TEST(Mismatch, OfASweepNamesTheCase) {
  const Found f = find({"sweep", "circular", "--hostile", "5000", "--seed", "9"}, 20, "ct7");
  ASSERT_EQ(f.report["runs"].size(), 2U);
  EXPECT_EQ(f.report["runs"][0]["verdict"], "match");
  EXPECT_FALSE(f.report["runs"][0].contains("mismatch"));
  EXPECT_EQ(f.report["runs"][1]["verdict"], "mismatch");
  EXPECT_EQ(f.report["runs"][1]["parameters"], (json{{"W", 32}}));
  EXPECT_EQ(f.report["mismatch"]["case"], "case 0: 1000 hostile clocks, seed 9");
}

TEST(Mismatch, IsNoneWhereTheMachineIsRight) {
  EXPECT_EQ(faulty({"line", "--major", "27", "--minor", "9"}).status, 0);
  EXPECT_EQ(faulty({"arc", "--radius", "12"}).status, 0);
}

// The verdict is the status even where the report cannot be written in the end.
TEST(Mismatch, IsSaidBeforeTheReportFails) {
  const Ended ended = ends(2, faulty({"arc", "--radius", "100000", "--report", "/dev/full"}));
  EXPECT_TRUE(has(ended.out, "verdict: MISMATCH\n"));
}

}  // namespace
}  // namespace cosim::cli
