// cosim equiv --assume: what is only so while expressions over the ports hold.
#include <gtest/gtest.h>

#include <string>

#include "tb/util/json.h"
#include "tests/cli/equiv_pairs.h"

namespace cosim::cli {
namespace {

// Two choices, of which `both` says what comes where both are asked for.
std::string chosen(const std::string& both) {
  return module_of(
      ", input a, b, input [3:0] d, e, output reg [3:0] q",
      "always @(posedge clk) q <= rst ? 0 : a & b ? " + both + " : a ? d : b ? e : 0;");
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
