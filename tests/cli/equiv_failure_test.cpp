// cosim equiv: what a difference leaves, a page and a wave; and whether only the time differs.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/equiv_pairs.h"
#include "tests/support/vcd.h"

namespace cosim::cli {
namespace {

using Json = nlohmann::json;

// A register behind its input, in an instance; the new one negates what it holds where d is `when`.
std::string rtl(const std::string& kept, const std::string& ports = "input [3:0] d") {
  return "module part(input clk, input rst, input [3:0] d, output reg [3:0] s);\n"
         "always @(posedge clk) if (rst) s <= 0; else s <= " +
         kept + ";\nendmodule\n" +
         module_of(", " + ports + ", output [3:0] q, output [79:0] wide",
                   "part p(clk, rst, d, q); assign wide = {76'h0, q};");
}

class EquivFailure : public InAFolder {
 protected:
  Ended told_apart(const std::string& gold, const std::string& gate, const Arguments& more = {}) {
    return cosim(
        joined({"equiv", "--gold", folder.write("gold.v", gold), "--gate",
                folder.write("gate.v", gate), "--top", "m", "--failures", folder.path("kept"),
                "--report", folder.path("report.json"), "--html", folder.path("page.html")},
               more));
  }
  std::string kept(const std::string& name) const { return folder.text("kept/m-equiv/" + name); }
  Json report() const { return Json::parse(folder.text("report.json")); }
  // Of a signal of the wave, in the middle of a clock, from 0.
  std::string at(const std::string& signal, int clock) const {
    const test::Vcd wave(folder.path("kept/m-equiv/wave.fst"));
    return wave.at(signal, static_cast<std::uint64_t>(10 * clock + 2)).value_or("nothing");
  }
};
using EquivReplayWave = EquivFailure;

TEST_F(EquivFailure, LeavesAPageAndAWave) {
  const Ended ended = ends(1, told_apart(rtl("d"), rtl("d ^ 8"), {"--netlists"}));
  // The reset is three clocks; the first register behind it differs on the fifth, which is
  // number 4 wherever it is named.
  EXPECT_TRUE(has(ended.out, "m: different on clock 4"));
  EXPECT_TRUE(has(kept("report.txt"), "m: different on clock 4"));
  const std::string csv = kept("stimulus.csv");
  EXPECT_TRUE(has(csv, "\n4,"));
  EXPECT_FALSE(has(csv, "\n5,"));
  const std::string page = kept("report.html");
  EXPECT_EQ(folder.text("page.html"), page);
  expect_has(page, {"class=\"verdict bad\"", ">q old<", ">q new<", "from reset: rst is 1",
                    "differ on clock 4,"});
  EXPECT_LT(page.find(">q old<"), page.find(">q new<"));
  EXPECT_TRUE(has(kept("wave.gtkw"), "+{q old} cosim.old.q[3:0]"));
  if (!test::can_read_waves()) GTEST_SKIP() << "no fst2vcd";
  const Json last = report()["stimulus"].back();
  EXPECT_EQ(Json(at("cosim.old.q", 4)), last["old"]["q"]);
  EXPECT_EQ(Json(at("cosim.new.q", 4)), last["new"]["q"]);
  EXPECT_EQ(Json(at("cosim.old.wide", 4)), last["old"]["wide"]);
  EXPECT_EQ(Json(at("cosim.inputs.d", 4)), last["inputs"]["d"]);
  EXPECT_EQ(at("cosim.mismatch.q", 4), "1");
  EXPECT_EQ(at("cosim.mismatch.q", 3), "0");
}

TEST_F(EquivFailure, APageOfWhatIsEqual) {
  ends(0, told_apart(rtl("d"), rtl("~(~d)")));
  const std::string page = folder.text("page.html");
  expect_has(page, {"class=\"verdict good\">equal<", "m: equal for ever"});
}

TEST_F(EquivFailure, SaysWhereOnlyTheTimeDiffers) {
  const auto stage = [](const std::string& more) {
    return module_of(", input [3:0] d, output reg [3:0] q, output y",
                     "reg [3:0] p; assign y = d[0]; always @(posedge clk) if (rst) begin p <= 0; q "
                     "<= 0; end else begin p <= d; q <= " +
                         more + "; end");
  };
  const std::string said =
      "only the time differs on these clocks: the values in their order are the "
      "same, in the new q 1 clock ";
  const Ended later = told_apart(stage("d"), stage("p"), {"--netlists"});
  EXPECT_TRUE(has(later.out, said + "later\n"));
  EXPECT_TRUE(has(kept("report.html"), said));
  EXPECT_EQ(report()["only_the_time_differs"], true);
  EXPECT_EQ(report()["later"]["q"], 1);
  // Another value, and a value that never comes.
  for (const char* other : {"~p", "p + 1"}) {
    const Ended ended = ends(1, told_apart(stage("d"), stage(other), {"--netlists"}));
    EXPECT_FALSE(has(ended.out, "only the time")) << other;
    EXPECT_EQ(report()["only_the_time_differs"], false);
  }
}

TEST_F(EquivReplayWave, DrawsTheHierarchiesOfBoth) {
  if (!test::can_read_waves()) GTEST_SKIP() << "no fst2vcd";
  const Ended ended = ends(1, told_apart(rtl("d"), rtl("d ^ 8")));
  EXPECT_TRUE(has(ended.out, "replayed in Icarus Verilog"));
  const Json last = report()["stimulus"].back();
  EXPECT_EQ(Json(at("old.p.s", 4)), last["old"]["q"]);
  EXPECT_EQ(Json(at("new.p.s", 4)), last["new"]["q"]);
  EXPECT_EQ(at("old.p.s", 3), "0000");
  EXPECT_EQ(Json(at("new.p.d", 4)), last["inputs"]["d"]);
}

}  // namespace
}  // namespace cosim::cli
