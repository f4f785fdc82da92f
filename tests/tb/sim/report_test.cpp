// What a run says of itself, in words and as JSON.
// Needs: linear, circular
#include "tb/sim/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/designs/circular/records.h"
#include "tests/designs/linear/records.h"
#include "tests/support/members.h"
#include "tests/support/model_adapter.h"

namespace cosim {
namespace {

using nlohmann::json;

const AnyBench& arcs() { return test::model_bench<circular::Design, circular::of_width(4)>(); }
const AnyBench& lines() { return test::model_bench<linear::Design, linear::of(5, 2)>(); }

Result good(std::uint64_t clocks) {
  Result r;
  r.cases = 1;
  r.clocks = clocks;
  r.checked.jobs = 1;
  r.checked.measures = {{"turns", Measure::Sum::total, "", "turn", std::uint64_t{17}},
                        {"deepest", Measure::Sum::largest, "deepest", "step", 0.25}};
  return r;
}

Result parted() {
  Result r = good(6);
  Mismatch m;
  m.clock = 5;
  m.signal = "ct7";
  m.field = arcs().compared()[3];
  m.expected = 4;
  m.actual = 6;
  m.first = 5;
  m.traces = {{m.field, Trace::Kind::reg, {4}, {6}}};
  r.mismatch = m;
  r.failed = "case 3: R = 12";
  return r;
}

Result objected() {
  Result r = good(9);
  r.checked.error = "oracle 8 steps, machine 7";
  r.failed = "case 0: R = 12";
  return r;
}

TEST(Report, HasNoFigureThatIsNotFinite) {
  Outcome outcome{&lines(), "a line", good(7)};
  EXPECT_NO_THROW(report_json({outcome}, 1));
  EXPECT_THROW(report_json({outcome}, 1, R"({"off":[1,null]})"), std::logic_error);
  for (const double figure : {HUGE_VAL, std::nan("")}) {
    outcome.result.checked.measures.back().value = figure;
    EXPECT_THROW(report_json({outcome}, 1), std::logic_error);
  }
}

// As those of two shapes, one of which has more words of a memory.
TEST(Results, OfMoreSignalsAreAdded) {
  Result sum = good(3), one = good(4);
  sum.left_out = {1};
  one.left_out = {2, 3};
  add(sum, one);
  EXPECT_EQ(sum.left_out, (std::vector<std::uint64_t>{3, 3}));
}

TEST(ReportText, CountsTheSignals) {
  EXPECT_EQ(compared_signals({&lines()}), "9 registers and 4 outputs");
  EXPECT_EQ(compared_signals({&arcs()}), "5 registers and 3 outputs");
  EXPECT_EQ(compared_signals({&arcs(), &lines(), &arcs()}), "5 to 9 registers and 3 to 4 outputs");
}

TEST(ReportText, EndsWithTheVerdict) {
  EXPECT_EQ(verdict_text({{&arcs(), "arcs", good(1)}}), "verdict: match\n");
  EXPECT_EQ(verdict_text({{&lines(), "lines", good(1)}, {&arcs(), "arcs", parted()}}),
            "circular W=4, case 3: R = 12\n" + to_text(*parted().mismatch) + "verdict: MISMATCH\n");
  EXPECT_EQ(verdict_text({{&arcs(), "arcs", objected()}}),
            "circular W=4, case 0: R = 12\n"
            "RTL and model agree, but the checker reports: oracle 8 steps, machine 7\n"
            "verdict: MISMATCH\n");
}

// Of a run in lockstep: no clock, or none on which anything meant something.
TEST(ReportText, SaysWhereNothingWasCompared) {
  Result never = good(3);
  never.left_out.assign(arcs().compared().size(), 3);
  for (const Result& empty : {good(0), never}) {
    const Outcome outcome{&arcs(), "arcs", empty};
    EXPECT_TRUE(compared_nothing(outcome));
    EXPECT_EQ(verdict_text({{&lines(), "lines", good(1)}, outcome}), "verdict: nothing compared\n");
    EXPECT_EQ(json::parse(report_json({outcome}, 1))["verdict"], "nothing compared");
    EXPECT_EQ(nothing_text(outcome).find("circular W=4: nothing was compared: "), 0U);
  }
  never.left_out.back() = 2;
  EXPECT_FALSE(compared_nothing({&arcs(), "arcs", never}));
  EXPECT_FALSE(compared_nothing({&arcs(), "arcs", good(1)}));
  Result differs = parted();
  differs.clocks = 0;
  EXPECT_EQ(verdict_of({{&arcs(), "arcs", differs}}), "MISMATCH");
}

TEST(ReportJson, OfOneRun) {
  const json j = json::parse(report_json({{&arcs(), "an arc", good(21)}}, 7, R"({"points": 18})"));
  test::expect_members(j, R"({"verdict": "match", "design": "circular", "parameters": {"W": 4},
    "work": "an arc", "clocks": 21, "turns": 17, "deepest": 0.25, "seed": 7, "points": 18})");
  EXPECT_EQ(j["compared_signals"],
            (json{"t4", "t16", "f", "ct7", "ct8", "running", "step_y", "step_x"}));
  EXPECT_FALSE(j.contains("mismatch"));
}

// A design without a check, or clocks that no check watches.
TEST(ReportJson, HasTheMeasuresThatWereTaken) {
  Result bare = good(21);
  bare.checked = {};
  for (const auto& outcomes : {std::vector<Outcome>{{&arcs(), "an arc", bare}},
                               {{&arcs(), "an arc", bare}, {&arcs(), "an arc", bare}}}) {
    const json j = json::parse(report_json(outcomes, 7));
    for (const json& one : {j, j["runs"][0]}) {
      for (const char* name : {"steps", "max_deviation", "turns", "deepest"}) {
        EXPECT_FALSE(one.contains(name)) << name;
      }
    }
  }
  const json both =
      json::parse(report_json({{&lines(), "a line", bare}, {&arcs(), "an arc", good(21)}}, 7));
  EXPECT_FALSE(both["runs"][0].contains("turns"));
  EXPECT_EQ(both["turns"], 17);
}

TEST(ReportJson, OfADifference) {
  const json j = json::parse(report_json({{&arcs(), "an arc", parted()}}, 1));
  EXPECT_EQ(j["verdict"], "mismatch");
  test::expect_members(j["mismatch"], R"-({"kind": "lockstep", "case": "case 3: R = 12", "clock": 5,
      "signal": "ct7", "expected": "00100 (4)", "actual": "00110 (6)"})-");
  EXPECT_EQ(j["mismatch"]["traces"][0],
            (json{{"signal", "ct7"}, {"first_clock", 5}, {"expected", {"4"}}, {"actual", {"6"}}}));
}

TEST(ReportJson, OfTheOraclesObjection) {
  const json j = json::parse(report_json({{&arcs(), "an arc", objected()}}, 1));
  EXPECT_EQ(j["verdict"], "mismatch");
  EXPECT_EQ(j["mismatch"]["kind"], "oracle");
  EXPECT_EQ(j["mismatch"]["what"], "oracle 8 steps, machine 7");
}

TEST(ReportJson, OfSeveralRuns) {
  const json j = json::parse(report_json({{&lines(), "lines", good(100)},
                                          {&arcs(), "arcs", good(10)},
                                          {&arcs(), "more arcs", parted()}},
                                         1));
  test::expect_members(j, R"({"verdict": "mismatch", "design": ["linear", "circular"],
                              "clocks": 116, "turns": 51, "deepest": 0.25})");
  ASSERT_EQ(j["runs"].size(), 3U);
  EXPECT_EQ(j["runs"][0]["verdict"], "match");
  EXPECT_EQ(j["runs"][2]["verdict"], "mismatch");
  EXPECT_EQ(j["mismatch"]["signal"], "ct7");
}

}  // namespace
}  // namespace cosim
