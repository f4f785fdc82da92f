// cosim equiv: pairs of which it is known whether they are the same.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/cli/equiv_pairs.h"

namespace cosim::cli {
namespace {

// Wherever it stands, and whatever yosys calls what has no name.
TEST(Equiv, TheSameNetlistNeedsNoEngine) {
  const std::string one = module_of(", input [7:0] a, b, output reg [7:0] q",
                                    "always @(posedge clk) q <= rst ? 0 : a * b + 1;");
  const Ended same = ends(0, equiv(one, "// moved\n\n" + one));
  EXPECT_TRUE(has(same.out, "equal for ever, by the same netlist"));
  expect_said(0, one,
              module_of(", input [7:0] a, b, (* mark = 1 *) output reg [7:0] q",
                        "(* told = \"so\" *) always @(posedge clk) "
                        "q <= rst ? 0 : a * b + 1;"),
              "by the same netlist");
  expect_different(one,
                   module_of(", input [7:0] a, b, output reg [7:0] q",
                             "always @(posedge clk) q <= rst ? 0 : a * b + 2;"),
                   "q is ");
  const auto first = [](const std::string& value) {
    return module_of(", input d, output reg q",
                     "initial q = " + value + "; always @(posedge clk) if (d) q <= d;");
  };
  expect_different(first("0"), first("1"), "q is 1, was 0");
}

// What yosys 0.23 cannot print is no part of what the RTL does; what else it cannot read is said.
TEST(Equiv, RtlThatPrints) {
  const auto rtl = [](const std::string& d) {
    return module_of(", input d, output reg q",
                     "initial $display(\"%0s; (\", \"$write(\"); always @(posedge clk) begin "
                     "q <= " +
                         d + "; if (d) $error(\"no %m\"); end");
  };
  expect_equal(rtl("d"), rtl("d & d"));
  expect_different(rtl("d"), rtl("!d"), "q is ");
  EXPECT_TRUE(
      has(ends(2, equiv(rtl("d"), rtl("$none(d)"))).err, "the new RTL: yosys cannot read it"));
}

TEST(Equiv, AGcdAndItsNetlist) {
  const Folder folder;
  const std::string gcd = folder.write(
      "gcd.v", module_of(", input start, input [3:0] a, b, output reg [3:0] x, output done",
                         "reg [3:0] y; assign done = y == 0; always @(posedge clk) if (rst) begin"
                         " x <= 0; y <= 0; end else if (start) begin x <= a; y <= b; end else if"
                         " (y != 0) begin if (x < y) begin x <= y; y <= x; end else x <= x - y;"
                         " end"));
  const std::string netlist = folder.path("netlist.v");
  // A list with commas is one word in a script alone.
  const std::string script = folder.write(
      "synth.ys", "read_verilog " + gcd + "\nsynth -flatten -top m\nabc -g AND,XOR,MUX\n" +
                      "opt_clean\nwrite_verilog -noattr " + netlist + "\n");
  const std::string make = "env -u HOME -u XDG_STATE_HOME yosys -q " + script;
  ASSERT_EQ(std::system(make.c_str()), 0);
  ends(0, cosim({"equiv", "--gold", gcd, "--gate", netlist, "--top", "m"}));
}

}  // namespace
}  // namespace cosim::cli
