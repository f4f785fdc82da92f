// The report: the keys that other programs read, and their types.
// Needs: linear, circular, toolpath
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/drawing.h"
#include "tests/support/members.h"
#include "tests/support/root.h"

namespace cosim::cli {
namespace {

using nlohmann::json;

void expect_numbers(const json& object) {
  EXPECT_EQ(object["verdict"], "match");
  EXPECT_TRUE(object["clocks"].is_number_unsigned());
  EXPECT_TRUE(object["steps"].is_number_unsigned());
  EXPECT_TRUE(object["max_deviation"].is_number_float());
  EXPECT_FALSE(object.contains("mismatch"));
}

void expect_signals(const json& names, const std::vector<std::string>& some, std::size_t all) {
  ASSERT_TRUE(names.is_array());
  EXPECT_EQ(names.size(), all);
  for (const std::string& name : some) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

// Registers and outputs of the two designs, by the numbers of the sources' blocks.
void expect_linear_signals(const json& names) {
  expect_signals(names,
                 {"counter4", "register5", "register3", "register9", "trigger10", "busy", "strobe",
                  "major", "minor"},
                 13);
}
void expect_circular_signals(const json& names) {
  expect_signals(names, {"t4", "t16", "f", "ct7", "ct8", "running", "step_x", "step_y"}, 8);
}

TEST(Report, OfALine) {
  const json r = draw({"line", "--major", "27", "--minor", "9"}).report;
  expect_numbers(r);
  // The clocks: BP, UK, start, the first word formed, four words and the end.
  test::expect_members(r, R"({"design": "linear", "parameters": {"M": 5, "N": 2}, "seed": 1,
                              "steps": 27, "clocks": 9})");
  expect_linear_signals(r["compared_signals"]);
}

TEST(Report, OfAnArc) {
  const json r = draw({"arc", "--radius", "12", "--seed", "5"}).report;
  expect_numbers(r);
  // The load with the start, 17 steps, the correction, the reset at the end and the clock after it.
  test::expect_members(r, R"({"design": "circular", "parameters": {"W": 4}, "seed": 5, "steps": 17,
                              "clocks": 21})");
  expect_circular_signals(r["compared_signals"]);
}

TEST(Report, OfAPathOfBothMachines) {
  const std::string file = (test::project_root() / "tests/toolpaths/hexafoil.ngc").string();
  const json r = draw({"path", file, "--steps-per-mm", "10"}).report;
  expect_numbers(r);
  EXPECT_EQ(r["design"], (json{"linear", "circular"}));
  EXPECT_EQ(r["file"], file);
  EXPECT_EQ(r["steps_per_mm"], 10.0);
  expect_linear_signals(r["compared_signals"]["linear"]);
  expect_circular_signals(r["compared_signals"]["circular"]);
  ASSERT_EQ(r["runs"].size(), 2U);
  ASSERT_EQ(r["parameters"].size(), 2U);
  std::uint64_t clocks = 0, steps = 0;
  double deviation = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const json& run = r["runs"][i];
    expect_numbers(run);
    EXPECT_EQ(run["design"], r["design"][i]);
    EXPECT_EQ(run["parameters"], r["parameters"][i]);
    clocks += run["clocks"].get<std::uint64_t>();
    steps += run["steps"].get<std::uint64_t>();
    deviation = std::max(deviation, run["max_deviation"].get<double>());
  }
  EXPECT_EQ(r["clocks"], clocks);
  EXPECT_EQ(r["steps"], steps);
  EXPECT_EQ(r["max_deviation"], deviation);
}

TEST(Report, OfASweep) {
  const Folder folder;
  ASSERT_EQ(cosim({"sweep", "circular", "--random", "5", "--report", folder.path("r")}).status, 0);
  const json r = json::parse(folder.text("r"));
  expect_numbers(r);
  EXPECT_EQ(r["design"], "circular");
  EXPECT_EQ(r["seed"], 1);
  expect_circular_signals(r["compared_signals"]);
  const std::vector<int> widths = {4, 8, 12, 16, 24, 32};
  ASSERT_EQ(r["runs"].size(), widths.size());
  for (std::size_t i = 0; i < widths.size(); ++i) {
    expect_numbers(r["runs"][i]);
    EXPECT_EQ(r["runs"][i]["parameters"], (json{{"W", widths[i]}}));
    EXPECT_EQ(r["parameters"][i], (json{{"W", widths[i]}}));
  }
}

TEST(Report, IsJsonWhateverTheFileIsCalled) {
  const Folder folder;
  const std::string file = folder.write("\xff \"\n.ngc", "G0 X1\n");
  const Drawing d = draw({"path", file, "--steps-per-mm", "10"});
  ASSERT_TRUE(d.report.is_object());
  EXPECT_TRUE(has(d.report["file"].get<std::string>(), " \"\n.ngc"));
  EXPECT_EQ(lines(d.ended.out).size(), 6U) << d.ended.out;
}

}  // namespace
}  // namespace cosim::cli
