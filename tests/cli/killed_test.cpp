// A sweep that is killed goes on from its checkpoint and ends as if nothing had happened.
// Needs: linear
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/cli/checkpoint.h"
#include "tests/support/sanitized.h"

namespace cosim::cli {
namespace {

using namespace std::string_literals;

constexpr int kKills = 20;
// Some seconds of work.
constexpr std::uint64_t kClocks = test::slow ? 900'000 : 9'000'000;

class KilledSweep : public InAFolder {
 protected:
  Arguments sweep(const Arguments& more) const {
    return joined({"sweep", "linear", "--hostile", std::to_string(kClocks), "--seed", "3"}, more);
  }
  Arguments kept() const {
    return sweep({"--checkpoint", folder.path("state"), "--report", folder.path("report")});
  }
  void run_until_kept() const {
    ASSERT_TRUE(killed_beyond(0, folder, kept())) << "it ended and kept nothing";
  }
  std::uint64_t cases_done() const { return cases_kept(folder); }
};

TEST_F(KilledSweep, EndsWithTheSameReport) {
  ASSERT_EQ(cosim(sweep({"--report", folder.path("expected")})).status, 0);
  const std::string expected = folder.text("expected");

  std::minstd_rand random(std::random_device{}());
  // By turns at any moment, from the first on, and some time behind the next checkpoint.
  std::uniform_int_distribution moment(0, 200);
  std::uint64_t done = 0;
  int killed = 0, advanced = 0;
  for (int i = 0; i < kKills; ++i) {
    const int after = moment(random);
    if (!(i % 2 == 0 ? cosim_killed(kept(), after)
                     : killed_beyond(done, folder, kept(), std::chrono::milliseconds(after)))) {
      // It was through: the report is whole, and the next run begins anew.
      EXPECT_EQ(folder.text("report"), expected);
      std::filesystem::remove(folder.path("report"));
      done = 0;
      continue;
    }
    ++killed;
    // Killed between writing the report and taking the checkpoint away, it may have left both.
    if (folder.holds("report")) EXPECT_EQ(folder.text("report"), expected);
    const std::uint64_t now = cases_done();
    EXPECT_GE(now, done) << "kill " << i;
    advanced += now > done;
    done = now;
  }
  EXPECT_GE(killed, kKills / 2);
  EXPECT_GE(advanced, 2);

  const Ended last = cosim(kept());
  EXPECT_EQ(last.status, 0) << last.err;
  EXPECT_EQ(folder.text("report"), expected);
  EXPECT_FALSE(folder.holds("state"));
}

// A checkpoint of part of the work is really gone on from: a false sum in it shows in the result.
TEST_F(KilledSweep, StartsFromWhatTheCheckpointSays) {
  ASSERT_NO_FATAL_FAILURE(run_until_kept());
  auto file = nlohmann::json::parse(folder.text("state"));
  file["state"][0]["clocks"] = file["state"][0]["clocks"].get<std::uint64_t>() + 7;
  folder.write("state", sealed(file));
  EXPECT_EQ(cosim(kept()).status, 0);
  const auto report = nlohmann::json::parse(folder.text("report"));
  EXPECT_EQ(report["runs"][0]["clocks"], kClocks + 7);
}

// The measures of a check are kept with all that it takes to go on and to print them.
TEST_F(KilledSweep, GoesOnWithWhatTheCheckMeasured) {
  const Arguments measured{
      "sweep", "linear",       "--random",           "500000",   "--m",
      "5",     "--checkpoint", folder.path("state"), "--report", folder.path("report")};
  ASSERT_TRUE(killed_beyond(0, folder, measured)) << "it ended and kept nothing";
  const std::string state = folder.text("state");
  const auto run_from = [&](const nlohmann::json& file) {
    folder.write("state", sealed(file));
    const Ended ended = cosim(measured);
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(has(ended.out, " steps, largest deviation "));
    return nlohmann::json::parse(folder.text("report"));
  };
  auto file = nlohmann::json::parse(state);
  const auto whole = run_from(file);
  auto& measures = file["state"][0]["measures"];
  ASSERT_EQ(measures.size(), 2U);
  measures[0]["value"] = measures[0]["value"].get<std::uint64_t>() + 7;
  measures[1]["value"] = 12345.5;
  const auto changed = run_from(file);
  EXPECT_EQ(changed["steps"], whole["steps"].get<std::uint64_t>() + 7);
  EXPECT_EQ(changed["max_deviation"], 12345.5);
  for (const char* none : {"-1", "\"1\"", "null"}) {
    measures[0]["value"] = nlohmann::json::parse(none);
    folder.write("state", sealed(file));
    EXPECT_TRUE(has(refusal(cosim(measured)),
                    "state: no checkpoint: state[0].measures[0].value is " + std::string(none)));
  }
}

void expect_refusal(const Ended& ended, const std::string& line) {
  EXPECT_TRUE(has(refusal(ended), line));
}

TEST_F(KilledSweep, RefusesACheckpointOfOtherWork) {
  ASSERT_NO_FATAL_FAILURE(run_until_kept());
  const std::string before = folder.text("state");
  const std::string refusal =
      folder.path("state") + ": a checkpoint of other work or of another build";
  expect_refusal(cosim({"sweep", "linear", "--hostile", std::to_string(kClocks + 1), "--seed", "3",
                        "--checkpoint", folder.path("state")}),
                 refusal);
  expect_refusal(cosim({"sweep", "linear", "--hostile", std::to_string(kClocks), "--seed", "4",
                        "--checkpoint", folder.path("state")}),
                 refusal);
  expect_refusal(another_build(kept()), refusal);
  EXPECT_EQ(folder.text("state"), before);
}

TEST_F(KilledSweep, RefusesCountsThatCannotBe) {
  ASSERT_NO_FATAL_FAILURE(run_until_kept());
  auto file = nlohmann::json::parse(folder.text("state"));
  const std::string too_many = std::to_string(kClocks / 1000 + 1);
  for (const std::string& cases : {too_many, "-1"s, "1e300"s, "\"1\""s, "null"s}) {
    file["state"][0]["cases"] = nlohmann::json::parse(cases);
    folder.write("state", sealed(file));
    expect_refusal(cosim(kept()), folder.path("state") + ": no checkpoint: state[0].cases is ");
  }
}

TEST_F(KilledSweep, RefusesACheckpointThatWasChanged) {
  ASSERT_NO_FATAL_FAILURE(run_until_kept());
  auto file = nlohmann::json::parse(folder.text("state"));
  file["state"][0]["clocks"] = file["state"][0]["clocks"].get<std::uint64_t>() + 7;
  folder.write("state", file.dump());
  expect_refusal(cosim(kept()), folder.path("state") + ": no checkpoint: it was changed");
}

TEST_F(KilledSweep, RefusesWhatIsNoCheckpoint) {
  const auto with = [&](const std::string& path) { return sweep({"--checkpoint", path}); };
  for (const char* text : {"", "hello", "[1,2]", "{\"work\":1}", "{\"work\":\"x\",\"state\":0"}) {
    const std::string path = folder.write("other", text);
    expect_refusal(cosim(with(path)), path + ": no checkpoint");
    EXPECT_EQ(folder.text("other"), text);
  }
  expect_refusal(cosim(with("/dev/null")), "/dev/null: no checkpoint: not a regular file");
  expect_refusal(cosim(with(folder.path("none/file"))), "cannot write");
  expect_refusal(cosim(with("")), "--checkpoint: names no file");
  const std::string same = folder.path("same");
  expect_refusal(cosim(sweep({"--checkpoint", same, "--report", same})),
                 "--checkpoint: " + same + " is the file of --report");
}

}  // namespace
}  // namespace cosim::cli
