// Regressions in which something does not hold, or cannot be run.
// Needs: linear, circular
#include "tests/regress/run.h"

namespace cosim::cli {
namespace {

// Of the faulty program: right at M=5 N=2 and wrong at M=32 N=26.
constexpr const char* one_wrong = R"(
  {"name": "good", "sweep": "linear M=5 N=2", "random": 50},
  {"name": "both", "sweep": "linear", "random": 300},
  {"name": "after", "sweep": "linear M=5 N=2", "hostile": 5000})";

TEST_F(Regression, WithAFaultIsTheSameHoweverItIsCut) {
  plan(one_wrong);
  for (const char* shards : {"1", "2", "7", "100"}) {
    const Ended e = ends(1, faulty(fresh(shards, {"--shards", shards})));
    EXPECT_TRUE(e.out.find("FAILED: both: linear M=32 N=26, ") < e.out.find("pass ")) << e.out;
    EXPECT_EQ(report(shards), report("1")) << shards;
  }
  const Json json = Json::parse(report("1"));
  EXPECT_EQ(json["verdict"], "fail");
  ASSERT_EQ(json["failures"].size(), 1U);
  EXPECT_EQ(json["tasks"][1]["works"][1]["result"]["mismatch"]["signal"], "counter4");

  // What stands there replays.
  const std::string folder = json["failures"][0]["folder"];
  ends(1, faulty({"replay", folder_.path("7/" + folder)}));
  EXPECT_EQ(json["failures"][0]["command"], "replay " + folder);
}

TEST_F(Regression, StopsAtAFailureWhereThatIsWanted) {
  plan(one_wrong);
  ends(1, faulty(fresh("run", {"--shards", "20", "--jobs", "1", "--fail-fast"})));
  const Json json = Json::parse(report("run"));
  EXPECT_EQ(json["verdict"], "unfinished");
  EXPECT_EQ(json["failures"].size(), 1U);
  EXPECT_EQ(json["tasks"][2]["works"][0]["verdict"], "unfinished");
  // Gone on with, it is the whole.
  EXPECT_EQ(faulty(resumed("run")).status, 1);
  EXPECT_EQ(faulty(fresh("whole", {"--shards", "1"})).status, 1);
  EXPECT_EQ(report("run"), report("whole"));
}

TEST_F(Regression, WhoseProgramFailsOrIsNotThereSaysSo) {
  plan(R"({"name": "fails", "run": ["sh", "-c", "echo one; echo why; exit 3"]},
          {"name": "good", "run": ["true"]},
          {"name": "none", "run": ["./no-such-program"]})");
  const Ended e = ends(1, cosim(fresh("run")));
  EXPECT_EQ(lines(e.err), std::vector<std::string>{"cosim: shard 2: needs ./no-such-program"});
  const Json json = Json::parse(report("run"));
  EXPECT_EQ(json["failures"][0]["what"], "status 3: why");
  EXPECT_EQ(json["tasks"][1]["works"][0]["verdict"], "pass");
  EXPECT_EQ(json["tasks"][2]["works"][0]["verdict"], "unfinished");
}

TEST_F(Regression, WhoseModelThrowsNoExceptionSaysSoInALine) {
  setenv("COSIM_FAULTY_THROWS", "1", 1);
  const Ended alone = faulty({"sweep", "linear", "--m", "32", "--n", "26", "--random", "3"});
  unsetenv("COSIM_FAULTY_THROWS");
  EXPECT_EQ(refusal(alone),
            "cosim: internal error: something was thrown that is no std::exception\n");
}

// As libFuzzer ends: the line that counts is not the last one.
TEST_F(Regression, NamesWhatFuzzingFinds) {
  std::filesystem::permissions(
      folder_.write("target",
                    "#!/bin/sh\necho 'SUMMARY: deadly signal'\necho Base64: AA==\n"
                    "case $* in *-seed=9*) exit 77 ;; esac\n"),
      std::filesystem::perms::owner_all);
  plan(R"({"name": "bytes", "fuzz": "target", "seconds": 121})");
  EXPECT_EQ(cosim(fresh("run")).status, 1);
  // Seed 7 and number 1, counted from 1: one of three slices of a minute or less.
  const Json failures = Json::parse(report("run"))["failures"];
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0]["what"], "slice 1: SUMMARY: deadly signal");
}

// One line for each thing that is wrong, with the file and the place; nothing is made.
void expect_refused(const Folder& folder, const std::string& text,
                    const std::vector<std::string>& wrong) {
  const std::string path = folder.write("plan.json", text);
  const Ended e = cosim({"regress", path, "--folder", folder.path("run")});
  EXPECT_EQ(e.status, 2) << text;
  std::vector<std::string> expected;
  for (const std::string& one : wrong) expected.push_back("cosim: " + path + ": " + one);
  EXPECT_EQ(lines(e.err), expected) << text;
  EXPECT_EQ(e.out, "");
  EXPECT_FALSE(folder.holds("run"));
}

TEST_F(Regression, OfABadPlanIsRefusedWhole) {
  const std::string head = R"({"format": 1, "name": "n", "tasks": [)";
  expect_refused(folder_, "x",
                 {"no JSON: at line 1, column 1: syntax error while parsing value - "
                  "invalid literal; last read: 'x'"});
  expect_refused(folder_, "[]", {"no plan: needs an object with \"format\": 1"});
  expect_refused(folder_, R"({"format": 2})", {"no plan: needs an object with \"format\": 1"});
  expect_refused(folder_, head + R"({"name": "a", "run": ["true"], "seed": 1, "seed": 2}]})",
                 {"'seed': occurs twice in an object"});
  expect_refused(folder_, R"({"format": 1, "more": 1})",
                 {"more: no such key", "name: is needed", "tasks: needs a list of tasks"});
  const std::string line = "needs printable characters on one line";
  expect_refused(folder_,
                 R"({"format": 1, "name": "\u001b[2J", "tasks": [
                     {"name": "a\nverdict: pass", "run": ["true"]}]})",
                 {"name: " + line, "tasks[0].name: " + line});
  expect_refused(folder_, head + "]}", {"tasks: needs a list of tasks"});
  expect_refused(folder_, head + R"({"name": "a", "sweep": "linear", "hostile": 0},
                {"name": "a", "sweep": "linear", "prove": "linear"},
                {"sweep": "linear", "random": "x", "minutes": -1, "foo": 1}, 7, {"name": "b"},
                {"name": "c", "run": []}, {"name": "", "sweep": "linear", "exhaustive": 1}]})",
                 {"tasks[0].hostile: needs a whole number from 1 to 281474976710656",
                  "tasks[1]: both \"sweep\" and \"prove\"",
                  "tasks[2].random: needs a whole number from 1 to 281474976710656",
                  "tasks[2].minutes: needs a whole number from 1 to 10000000",
                  "tasks[2].foo: no such key of \"sweep\"", "tasks[2]: name: is needed",
                  "tasks[3]: is no object",
                  "tasks[4]: has none of \"sweep\", \"prove\", \"mutate\", \"fuzz\", \"run\"",
                  "tasks[5].run: needs a list of texts", "tasks[6].name: needs a text",
                  "tasks[6].exhaustive: can only be true"});
  expect_refused(
      folder_,
      head + R"({"name": "a", "sweep": "linear"}, {"name": "b", "sweep": "lin", "random": 3},
                {"name": "c", "sweep": "linear M=32", "exhaustive": true},
                {"name": "d", "mutate": "lin"}, {"name": "e", "fuzz": "none"},
                {"name": "f", "prove": "linear M=99"},
                {"name": "g", "mutate": "linear", "programs": ["plan.json"]}]})",
      {"tasks[0]: needs one of \"exhaustive\", \"random\" and \"hostile\"",
       "tasks[1]: 'lin' is not built; see cosim list",
       "tasks[2]: exhaustive: too wide to try everything; take M <= 8, or more with \"lanes\"",
       "tasks[3]: 'lin' is not built; see cosim list", "tasks[4]: fuzz: no such file: none",
       "tasks[5]: 'linear M=99' is not built; see cosim list",
       "tasks[6]: plan.json: cannot be run"});
}

TEST_F(Regression, OfABadCommandLineIsRefused) {
  plan(R"({"name": "a", "run": ["true"]})");
  const auto said = [](const Arguments& more) { return refusal(cosim(joined({"regress"}, more))); };
  const std::string file = folder_.path("plan.json");
  EXPECT_EQ(said({}), "cosim: regress: needs a FILE, or --resume FOLDER\n");
  EXPECT_TRUE(has(said({file, "--shards", "0"}), "--shards"));
  EXPECT_TRUE(has(said({file, "--seed", "1"}), "has a seed of its own, 7"));
  EXPECT_TRUE(has(said({"--resume", folder_.path("x")}), "is not the folder of a regression"));
  EXPECT_TRUE(has(said({file, "--folder", folder_.path("")}), "already exists"));
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"plan.json"});
}

}  // namespace
}  // namespace cosim::cli
