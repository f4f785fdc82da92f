// cosim equiv: which inputs reset, told from the RTL.
#include <gtest/gtest.h>

#include "tests/cli/equiv_pairs.h"

namespace cosim::cli {
namespace {

// A ring of three states, whose codes are equal after a reset alone: `first` is given by `reset`.
std::string ring(const std::string& pins, const std::string& sensitive, const std::string& reset,
                 bool one_hot) {
  const std::string process = "always @(posedge clk" + sensitive + ") if (" + reset + ") s <= ";
  const std::string head = "module m(input clk, " + pins + ", input a, output y);\n";
  return one_hot ? head + "reg [2:0] s; " + process +
                       "1; else if (a) s <= {s[1:0], s[2]}; assign y = s[2]; endmodule\n"
                 : head + "reg [1:0] s; " + process +
                       "0; else if (a) s <= s == 2 ? 0 : s + 1; assign y = s == 2; endmodule\n";
}

void expect_found(const std::string& pins, const std::string& sensitive, const std::string& reset,
                  const std::string& said) {
  expect_said(0, ring(pins, sensitive, reset, true), ring(pins, sensitive, reset, false),
              "from reset: " + said + " for 3 clocks");
}

TEST(EquivResets, TheOneThatGivesRegistersAConstant) {
  expect_found("input resetq", "", "!resetq", "resetq is 0");
  expect_found("input core_clear, input rst_busy", "", "core_clear", "core_clear is 1");
  expect_found("input CLR", "", "CLR", "CLR is 1");
}

TEST(EquivResets, EachThatIsAsynchronous) {
  expect_found("input power", " or negedge power", "!power", "power is 0");
  const auto two = [](bool one_hot) {
    std::string rtl = ring("input p, input q_n", " or posedge p", "p", one_hot);
    rtl.replace(rtl.find("output y"), 8, "output y, output reg z");
    return rtl.insert(rtl.find("endmodule"),
                      "always @(posedge clk or negedge q_n) if (!q_n) z <= 0; else z <= y;");
  };
  expect_said(0, two(true), two(false), "from reset: p is 1 and q_n is 0 for 3 clocks");
}

TEST(EquivResets, OneThatTheNewRtlAloneHasRegistersFor) {
  expect_equal("module m(input clk, input clr_n, input a, output y); assign y = 0; endmodule\n",
               "module m(input clk, input clr_n, input a, output y); reg q; always @(posedge clk)\n"
               " if (!clr_n) q <= 0; else q <= q & a; assign y = q; endmodule\n");
}

TEST(EquivResets, OneBehindRegisters) {
  const auto late = [](bool one_hot) {
    std::string rtl = ring("input rst_n", "", "!r[1]", one_hot);
    return rtl.insert(rtl.find("reg"), "reg [1:0] r; always @(posedge clk) r <= {r[0], rst_n};\n");
  };
  expect_equal(late(true), late(false));
}

TEST(EquivResets, OneOfEachClock) {
  const auto rtl = [](bool one_hot) {
    std::string one = ring("input clk_b, a_rst, b_rst", "", "a_rst", one_hot);
    const std::string other = one_hot ? "reg n; always @(posedge clk_b) n <= b_rst ? 0 : ~n; wire"
                                        " z = n;"
                                      : "reg n; always @(posedge clk_b) n <= b_rst ? 1 : ~n; wire"
                                        " z = ~n;";
    one.replace(one.find("output y"), 8, "output y, output x");
    return one.insert(one.find("endmodule"), other + " assign x = z;");
  };
  expect_said(0, rtl(true), rtl(false), "from reset: a_rst is 1 and b_rst is 1 for 3 clocks");
}

TEST(EquivResets, TheyAreNamed) {
  const std::string pins = "input go, input stop";
  const auto rtl = [&](bool one_hot) { return ring(pins, "", "go && !stop", one_hot); };
  expect_different(rtl(true), rtl(false), "y is ");
  expect_equal(rtl(true), rtl(false), {"--reset", "go", "--reset", "stop=0"});
}

}  // namespace
}  // namespace cosim::cli
