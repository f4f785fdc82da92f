// cosim equiv --assume: what is only so while expressions over the ports hold.
#include <gtest/gtest.h>

#include <string>

#include "tb/support/json.h"
#include "tests/cli/equiv_pairs.h"

namespace cosim::cli {
namespace {

// Two choices, of which `both` says what comes where both are asked for.
std::string chosen(const std::string& both) {
  return module_of(
      ", input a, b, input [3:0] d, e, output reg [3:0] q",
      "always @(posedge clk) q <= rst ? 0 : a & b ? " + both + " : a ? d : b ? e : 0;");
}

TEST(EquivAssume, InputsOnTheSameClock) {
  const std::string gold = chosen("d"), gate = chosen("d | e");
  expect_different(gold, gate, "q is ");
  expect_said(0, gold, gate, "assumed: !(a & b)\n", {"--assume", "!(a & b)"});
  expect_equal(gold, gate, {"--assume", "d == 4'd3 || a", "--assume", "!b"});
  // Words that say less than is needed.
  expect_different(gold, gate, "q is ", {"--assume", "a | b"});
}

// It holds on the clocks before, too, but not in the reset.
TEST(EquivAssume, ClocksAfterTheResetAlone) {
  const auto rtl = [](const std::string& reset, const std::string& q) {
    return module_of(", input a, b, output q", "reg s, t; assign q = " + q +
                                                   "; always @(posedge clk) begin s <= a" + reset +
                                                   "; t <= b" + reset + "; end");
  };
  const Arguments more{"--reset", "rst", "--assume", "!(a & b)"};
  expect_equal(rtl(" & !rst", "s & t"), rtl(" & !rst", "1'b0"), more);
  expect_different(rtl("", "s & t"), rtl("", "1'b0"), "different on clock 3: q is 0, was 1", more);
}

TEST(EquivAssume, Outputs) {
  const auto counter = [](const std::string& when) {
    return module_of(", input up, output full, output reg [1:0] n",
                     "assign full = n == 3; always @(posedge clk) if (rst) n <= 0; else if (" +
                         when + ") n <= n + 1;");
  };
  expect_different(counter("up & !full"), counter("up"), "n is ");
  expect_equal(counter("up & !full"), counter("up"), {"--assume", "!(up & full)"});
}

// No stimulus that breaks it tells the two apart.
TEST(EquivAssume, HoldsInWhatIsKept) {
  const Folder folder;
  const auto rtl = [](const std::string& q) {
    return module_of(", input [7:0] d, output reg [7:0] q",
                     "always @(posedge clk) q <= rst ? 0 : " + q + ";");
  };
  ends(1, cosim({"equiv", "--gold", folder.write("a.v", rtl("d")), "--gate",
                 folder.write("b.v", rtl("d < 200 ? d : 0")), "--top", "m", "--assume",
                 "d[7:1] == 100", "--netlists", "--failures", folder.path("kept"), "--report",
                 folder.path("r.json")}));
  const Json report = Json::parse(folder.text("r.json"));
  EXPECT_EQ(report["assumptions"], Json::array({"d[7:1] == 100"}));
  const Json& clocks = report["stimulus"];
  ASSERT_GE(clocks.size(), 5U);
  for (std::size_t i = 3; i < clocks.size(); ++i) {
    EXPECT_EQ(clocks[i]["inputs"]["d"].get<std::string>().substr(0, 7), "1100100") << i;
  }
}

TEST(EquivAssume, WhatIsNoneIsRefused) {
  const std::string rtl = chosen("d");
  const auto said = [&](const std::string& text) {
    return equiv(rtl, chosen("e"), {"--assume", text});
  };
  expect_refused(said("x == 1"), "--assume: 'x == 1': x is no port");
  expect_refused(said("clk"), "--assume: 'clk': clk is a clock");
  expect_refused(said("a)); initial $finish; assign b = ((d"), "is no expression of Verilog");
  expect_refused(said("a ="), "--assume: 'a =': syntax error");
  expect_refused(equiv(rtl, rtl, {"--assume", "a & !a"}), "no stimulus satisfies 'a & !a'");
}

}  // namespace
}  // namespace cosim::cli
