// A regression ends in the same report however it is cut, killed and gone on with.
// Needs: linear
#include <csignal>
#include <random>
#include <set>

#include "tb/util/hash.h"
#include "tests/regress/run.h"
#include "tests/support/solvers.h"

namespace cosim::cli {
namespace {

// Some seconds of work, of every kind that needs no program of its own.
constexpr const char* tasks = R"(
  {"name": "any pins", "sweep": "linear M=5 N=2", "hostile": 400000},
  {"name": "jobs", "sweep": "linear", "random": 3000, "seed": 11},
  {"name": "all", "sweep": "linear M=5 N=2", "exhaustive": true},
  {"name": "program", "run": ["true"]})";

class WholeRegression : public Regression {
 protected:
  void SetUp() override {
    plan(tasks);
    ends(0, cosim(fresh("one", {"--shards", "1"})));
    expected_ = report("one");
  }
  std::string expected_;
};

TEST_F(WholeRegression, IsTheSameInEveryByteHoweverItIsCut) {
  std::set<std::uint64_t> shards{times("one")["shards"].get<std::uint64_t>()};
  for (const char* number : {"2", "7", "100"}) {
    ends(0, cosim(fresh(number, {"--shards", number})));
    EXPECT_EQ(report(number), expected_) << number;
    EXPECT_EQ(folder_.text(number + std::string("/report.txt")), folder_.text("one/report.txt"));
    shards.insert(times(number)["shards"].get<std::uint64_t>());
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path(number + std::string("/checkpoints"))));
  }
  EXPECT_GE(shards.size(), 2U) << "it was always cut alike";
  EXPECT_GE(*shards.rbegin(), 70U);
}

TEST_F(WholeRegression, SaysWhatTheSweepItselfSays) {
  ASSERT_EQ(cosim({"sweep", "linear", "--m", "5", "--n", "2", "--hostile", "400000", "--seed", "7",
                   "--report", folder_.path("sweep")})
                .status,
            0);
  const Json sweep = Json::parse(folder_.text("sweep"))["runs"][0];
  Json result = Json::parse(expected_)["tasks"][0]["works"][0]["result"];
  EXPECT_EQ(result["cases"], 400);
  result.erase("cases");
  EXPECT_EQ(result, sweep);
}

// Killed in every phase: while it is made, in shards, while the report is written.
TEST_F(WholeRegression, GoesOnAfterKills) {
  std::minstd_rand random(std::random_device{}());
  std::uniform_int_distribution moment(0, 600);
  for (const char* shards : {"1", "40"}) {
    int killed = 0;
    bool made = false;
    for (int i = 0; i < 8; ++i) {
      const Arguments arguments = made ? resumed("run") : fresh("run", {"--shards", shards});
      killed += cosim_killed(arguments, moment(random)) ? 1 : 0;
      made = folder_.holds("run/run.json");
      if (!made) std::filesystem::remove_all(folder_.path("run"));
    }
    EXPECT_GE(killed, 2);
    ends(0, cosim(made ? resumed("run") : fresh("run", {"--shards", shards})));
    EXPECT_EQ(report("run"), expected_) << shards;
    std::filesystem::remove_all(folder_.path("run"));
  }
}

TEST_F(WholeRegression, RunsAgainWhatHasOnlyHalfALine) {
  ASSERT_EQ(cosim(fresh("run", {"--shards", "40"})).status, 0);
  const std::string name = "run/" + results_of("run");
  const std::string text = folder_.text(name);
  folder_.write(name, text.substr(0, text.size() - 20));
  std::filesystem::remove(folder_.path("run/report.json"));
  EXPECT_EQ(cosim(resumed("run")).status, 0);
  EXPECT_EQ(report("run"), expected_);
  EXPECT_EQ(times("run")["torn"], 1);
  EXPECT_EQ(times("run")["twice"], 0);

  folder_.write("run/results/zz.jsonl", text);
  EXPECT_EQ(cosim(resumed("run")).status, 0);
  EXPECT_EQ(report("run"), expected_);
  EXPECT_EQ(times("run")["twice"], times("run")["shards"]);
}

TEST_F(WholeRegression, IsThatOfOneProgramAndOnePlan) {
  EXPECT_TRUE(has(refusal(another_build(resumed("one"))), "a run of another program or build"));
  std::string plan = folder_.text("one/plan.json");
  plan.replace(plan.find("400000"), 6, "400001");
  folder_.write("one/plan.json", plan);
  EXPECT_TRUE(has(refusal(cosim(resumed("one"))), "its plan.json was changed"));
}

// Every value of run.json, replaced by those of each other kind, or gone.
TEST_F(WholeRegression, IsOfARunJsonThatNobodyChanged) {
  const Json whole = Json::parse(folder_.text("one/run.json"));
  const Json others =
      Json::parse(R"([null, true, 7, -1, 18446744073709551615, 1e300, "x", [], {}, [{}]])");
  const auto refused = [&](const std::string& text) {
    folder_.write("one/run.json", text);
    SCOPED_TRACE(text);
    const std::string said = refusal(cosim(resumed("one")));
    EXPECT_FALSE(has(said, "internal error"));
    EXPECT_TRUE(has(said, "one"));
  };
  const Json flat = whole.flatten();
  for (const auto& place : flat.items()) {
    for (const Json& other : others) {
      Json changed = whole;
      changed[Json::json_pointer(place.key())] = other;
      if (changed != whole) refused(changed.dump());
    }
  }
  for (const auto& place : whole.items()) {
    Json changed = whole;
    changed.erase(place.key());
    refused(changed.dump());
  }
  for (const char* text : {"", "[]", "7", "{", "{}"}) refused(text);
  Json fewer = whole;
  fewer["works"].erase(0);
  refused(fewer.dump());
  fewer["works"] = Json::array();
  refused(fewer.dump());
}

TEST_F(WholeRegression, RunsAgainAResultThatWasChanged) {
  const std::string name = "one/" + results_of("one");
  std::string text = folder_.text(name);
  const std::size_t at = text.find("\"cases\":400");
  ASSERT_NE(at, std::string::npos) << text;
  text.replace(at, 11, "\"cases\":500");
  folder_.write(name, text);
  EXPECT_EQ(cosim(resumed("one")).status, 0);
  EXPECT_EQ(report("one"), expected_);
  EXPECT_EQ(times("one")["torn"], 1);
}

// Whoever changes what was to be done, or what was done, and mends the hashes too.
TEST_F(Regression, IsOfTheUnitsThatThePlanComesTo) {
  using Ordered = nlohmann::ordered_json;
  plan(R"({"name": "a", "sweep": "linear M=5 N=2", "hostile": 5000})");
  ASSERT_EQ(cosim(fresh("run", {"--shards", "1"})).status, 0);
  const std::string run = folder_.text("run/run.json"), results = "run/" + results_of("run");
  const auto sealed = [](Ordered json, const std::string& before) {
    json.erase("hash");
    json["hash"] = hash_of(before + json.dump());
    return json.dump() + '\n';
  };
  const auto refused = [&](const std::string& line) {
    EXPECT_TRUE(has(refusal(cosim(resumed("run"))), line));
  };
  Ordered json = Ordered::parse(run);
  json["works"][0]["units"] = 3;
  folder_.write("run/run.json", sealed(json, ""));
  refused("run/run.json: task 'a' is divided into other work on this host");

  folder_.write("run/run.json", run);
  Ordered line = Ordered::parse(folder_.text(results));
  line["result"]["cases"] = 3;
  folder_.write(results, sealed(line, Ordered::parse(run)["hash"].get<std::string>()));
  refused("run/results: shard 0: cases is 3, not 5");
}

// What needs other programs: the solvers, and one that attacks mutants.
TEST_F(Regression, OfProofsAndMutantsIsTheSameHoweverItIsCut) {
  if (!test::can_prove()) GTEST_SKIP() << "needs yosys";
  plan(R"({"name": "claims", "prove": "linear M=5 N=2"},
          {"name": "mutants", "mutate": "linear M=5 N=2"})");
  for (const char* shards : {"1", "9"}) {
    ends(0, cosim(fresh(shards, {"--shards", shards})));
    EXPECT_EQ(report(shards), report("1"));
  }
  const Json report = Json::parse(this->report("9"));
  EXPECT_EQ(report["tasks"][0]["works"][0]["result"]["claims"].size(), 3U);
  const Json result = report["tasks"][1]["works"][0]["result"];
  EXPECT_EQ(result["mutants"], 100);
  EXPECT_EQ(result["outcomes"][99]["mutant"], 100);
  EXPECT_EQ(result["survived"], 0);
}

TEST_F(Regression, SaysWhenItIsInterruptedHowToGoOn) {
  plan(R"({"name": "a", "sweep": "linear M=5 N=2", "hostile": 4000000})");
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string name = "run" + std::to_string(signal);
    const Ended e = cosim_signalled(fresh(name, {"--shards", "1"}), signal,
                                    [&] { return folder_.holds(name + "/checkpoints/0"); });
    EXPECT_EQ(e.status, 128 + signal);
    expect_has(e.out, {"interrupted: 0 of 1 shard done", "regress --resume " + folder_.path(name)});
    EXPECT_TRUE(folder_.holds(name + "/checkpoints/0"));
    EXPECT_EQ(cosim(resumed(name)).status, 0);
  }
  EXPECT_EQ(report("run2"), report("run15"));
}

TEST_F(Regression, HasASeedOfItsOwnWhereThePlanHasNone) {
  folder_.write("plan.json", R"({"format": 1, "name": "n", "tasks": [
    {"name": "a", "sweep": "linear M=5 N=2", "hostile": 1000}]})");
  const Ended e = ends(0, cosim(fresh("one")));
  const auto seed = Json::parse(report("one"))["seed"].get<std::uint64_t>();
  EXPECT_TRUE(has(e.out, "seed " + std::to_string(seed)));
  EXPECT_EQ(cosim(fresh("two", {"--seed", std::to_string(seed)})).status, 0);
  EXPECT_EQ(report("two"), report("one"));
  EXPECT_EQ(cosim(fresh("three", {"--seed", "5"})).status, 0);
  EXPECT_NE(report("three"), report("one"));
}

TEST_F(Regression, MadeForADryRunLeavesNothing) {
  plan(tasks);
  const Ended e = ends(0, cosim(fresh("run", {"--dry-run", "--shards", "100", "--jobs", "2"})));
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"plan.json"});
  expect_has(e.out, {"any pins: linear M=5 N=2",
                     "expected to take 4 min of processor time, 2 min on 2 cores"});
}

}  // namespace
}  // namespace cosim::cli
