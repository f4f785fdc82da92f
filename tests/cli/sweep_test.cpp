// Sweeps: what they say they ran, and that a seed gives the same again.
// Needs: linear, circular
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/help.h"
#include "tests/cli/memory.h"
#include "tests/cli/program.h"
#include "tests/designs/circular/cli/circle.h"

namespace cosim::cli {
namespace {

using nlohmann::json;

struct Swept {
  Ended ended;
  json report;
};

Swept sweep(const Arguments& arguments) {
  const Folder folder;
  Swept s;
  s.ended = cosim(joined(joined({"sweep"}, arguments), {"--report", folder.path("r")}));
  EXPECT_EQ(s.ended.status, 0);
  EXPECT_EQ(s.ended.err, "");
  EXPECT_TRUE(s.ended.out.ends_with("\nverdict: match\n")) << s.ended.out;
  // Nothing moves where there is no terminal.
  EXPECT_EQ(s.ended.out.find_first_of("\r\x1b"), std::string::npos) << s.ended.out;
  s.report = json::parse(folder.text("r"), nullptr, false);
  return s;
}

// The clocks of the runs, which must add up to the report's.
std::vector<std::uint64_t> clocks_of_runs(const json& report) {
  std::vector<std::uint64_t> clocks;
  std::uint64_t sum = 0;
  for (const json& run : report["runs"]) {
    clocks.push_back(run["clocks"].get<std::uint64_t>());
    sum += clocks.back();
  }
  EXPECT_EQ(report["clocks"], sum);
  return clocks;
}

// All that can be swept.
std::vector<std::string> designs() {
  std::vector<std::string> all;
  for (const Arguments& command : commands({"sweep"})) all.push_back(command.back());
  EXPECT_FALSE(all.empty());
  return all;
}

TEST(Sweep, RunsOnEveryWidthBuilt) {
  const Swept lines_swept = sweep({"linear", "--random", "20"});
  expect_has(lines_swept.ended.out,
             {"linear M=5 N=2, ", "linear M=6 N=3, ", "linear M=8 N=5, ", "linear M=16 N=12, ",
              "linear M=16 N=13, ", "linear M=24 N=21, ", "linear M=32 N=26, "});
  EXPECT_EQ(lines_swept.report["design"], "linear");
  EXPECT_EQ(clocks_of_runs(lines_swept.report).size(), 7U);
  const Swept arcs = sweep({"circular", "--random", "20"});
  expect_has(arcs.ended.out, {"circular W=4, ", "circular W=8, ", "circular W=12, ",
                              "circular W=16, ", "circular W=24, ", "circular W=32, "});
  EXPECT_EQ(arcs.report["design"], "circular");
  EXPECT_EQ(clocks_of_runs(arcs.report).size(), 6U);
}

// Every BP of five bits with every UK of five bits: BP steps each, and at least BP / 8 clocks.
TEST(Sweep, ExhaustsTheLinesOfFiveBits) {
  const Swept s = sweep({"linear", "--exhaustive", "--m", "5"});
  EXPECT_EQ(s.report["steps"], 32 * (31 * 32 / 2));
  EXPECT_EQ(s.report["parameters"], (json{{"M", 5}, {"N", 2}}));
}

// Every start of every radius of four bits, and each of these arcs stopped after every number of
// steps from 0 to one past its end.
TEST(Sweep, ExhaustsTheArcsOfFourBits) {
  std::int64_t whole = 0, stopped = 0;
  for (std::int64_t r = 1; r <= 15; ++r) {
    const auto radius2 = static_cast<std::uint64_t>(r * r);
    const auto add = [&](Lattice from) {
      std::int64_t n = 0;
      for (Lattice p = from; p.x > 0; p = next_on_circle(p, radius2)) ++n;
      whole += n;
      stopped += n * (n + 1) / 2 + n;
    };
    for (std::int64_t along = 0; along <= r; ++along) {
      const std::int64_t across = across_from(along, radius2);
      if (across > along) add({across, along});
      if (across >= along) add({along, across});
    }
  }
  const Swept s = sweep({"circular", "--exhaustive", "--width", "4"});
  ASSERT_EQ(s.report["runs"].size(), 2U);
  EXPECT_EQ(s.report["runs"][0]["steps"], whole);
  EXPECT_EQ(s.report["runs"][1]["steps"], stopped);
}

TEST(Sweep, RunsSoManyHostileClocks) {
  for (const std::string& design : designs()) {
    const Swept s = sweep({design, "--hostile", "1234"});
    for (const std::uint64_t clocks : clocks_of_runs(s.report)) EXPECT_EQ(clocks, 1234U);
    // Hostile clocks draw nothing: nothing is said of steps.
    EXPECT_FALSE(has(s.ended.out, "step"));
    EXPECT_FALSE(s.report.contains("steps"));
    EXPECT_FALSE(s.report["runs"][0].contains("max_deviation"));
    EXPECT_TRUE(has(s.ended.out, ": 1234 clocks ("));
  }
  EXPECT_TRUE(
      has(sweep({"linear", "--hostile", "1", "--m", "5"}).ended.out, " on the one clock\n"));
}

// Whatever the threads do.
TEST(Sweep, GivesTheSameForTheSameSeed) {
  const auto report = [](const std::string& design, const char* seed, const char* jobs) {
    json r = sweep({design, "--random", "200", "--seed", seed, "--jobs", jobs}).report;
    r.erase("seed");
    return r;
  };
  for (const std::string& design : designs()) {
    EXPECT_EQ(report(design, "7", "1"), report(design, "7", "4"));
    EXPECT_NE(report(design, "7", "1"), report(design, "8", "1"));
  }
}

// However many cases run at once.
TEST(Sweep, GivesTheSameInLanes) {
  const bool at_the_root = std::filesystem::exists("/lanes");
  const auto report = [](const char* lanes) {
    return sweep({"linear", "--m", "5", "--hostile", "300001", "--seed", "7", "--lanes", lanes})
        .report;
  };
  const json alone = report("0");
  EXPECT_EQ(report("64"), alone);
  EXPECT_EQ(report("512"), alone);
  EXPECT_EQ(report("auto"), alone);
  // What was compiled is kept in the build folder, not at the root of the disk.
  const std::filesystem::path program = COSIM_PROGRAM;
  EXPECT_FALSE(std::filesystem::is_empty(program.parent_path().parent_path() / "lanes"));
  EXPECT_EQ(std::filesystem::exists("/lanes"), at_the_root);
}

TEST(Sweep, TakesNoMoreMemoryForMoreCases) {
  expect_no_more_memory({"linear", "--m", "5"});
  expect_no_more_memory({"circular", "--width", "4"});
}

TEST(Sweep, ReportsItsSeed) {
  EXPECT_EQ(sweep({"linear", "--random", "1", "--m", "5"}).report["seed"], 1);
  EXPECT_EQ(sweep({"linear", "--random", "1", "--m", "5", "--seed", "18446744073709551615"})
                .report["seed"],
            18446744073709551615U);
}

}  // namespace
}  // namespace cosim::cli
