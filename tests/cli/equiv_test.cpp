// cosim equiv: pairs of which it is known whether they are the same.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/cli/equiv_pairs.h"

namespace cosim::cli {
namespace {

TEST(Equiv, IsTheSameWithItself) {
  const std::string shift =
      module_of(", input d, output q",
                "reg [4:0] s; always @(posedge clk) s <= {s[3:0], d}; assign q = s[4];");
  expect_equal(shift, shift);
  const std::string again =
      module_of(", input d, output q",
                "reg [1:5] t; assign q = t[1]; always @(posedge clk) t <= {t[2:5], d};");
  expect_equal(shift, again);
  const std::string by =
      module_of(", input signed [15:0] a, input [3:0] n, output reg signed [15:0] q",
                "reg [3:0] m; always @(posedge clk) begin m <= n; q <= a >>> m; end");
  expect_equal(by, by);
}

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

TEST(Equiv, ComparesPortsWhoseBitsAreCountedFromAnotherNumber) {
  const auto rtl = [](const std::string& y, const std::string& z) {
    return module_of(", input [7:4] a, output [4:1] y, output [0:2] z",
                     "reg [5:2] r; always @(posedge clk) r <= a; assign y = {r[4:2], " + y +
                         "}, z = {r[2], 1'b0, " + z + "};");
  };
  expect_equal(rtl("1'b1", "r[5] & ~r[2]"), rtl("1'b1", "~(r[2] | ~r[5])"));
  expect_different(rtl("1'b1", "r[2]"), rtl("1'b1", "r[3]"), "z is ");
  expect_different(rtl("1'b1", "r[2]"), rtl("r[2]", "r[2]"), "y is ");
}

// Whose names are those of gates behind them.
TEST(Equiv, RegistersWithAnAsynchronousResetAreMatchedByName) {
  const auto rtl = [](const std::string& sum) {
    return "module m(input clk, input rst_n, input [3:0] d, output reg [3:0] q, output reg p);\n"
           "reg [3:0] n; always @(posedge clk or negedge rst_n) if (!rst_n) begin n <= 5; q <= 0;"
           " p <= 1; end else begin n <= " +
           sum + "; q <= n; p <= ^n; end endmodule\n";
  };
  expect_said(0, rtl("n + d"), rtl("d - ~n - 1"), "by registers by name");
}

TEST(Equiv, IsTheSameWrittenOtherwise) {
  expect_equal(module_of(", input [7:0] a, b, output reg eq, neq",
                         "always @(posedge clk) begin eq <= a == b; neq <= a != b; end"),
               module_of(", input [7:0] a, b, output reg eq, output neq",
                         "always @(posedge clk) eq <= ~|(a ^ b); assign neq = !eq;"),
               {"--reset", "rst"});
}

TEST(Equiv, FindsAnotherCodingOfTheStates) {
  expect_equal(
      module_of(", input a, output y",
                "reg [1:0] s; always @(posedge clk) if (rst) s <= 0; else case (s)"
                " 0: if (a) s <= 1; 1: s <= a ? 2 : 0; 2: s <= a ? 3 : 0; 3: if (!a) s <= 0;"
                " endcase assign y = s == 3;"),
      module_of(", input a, output y",
                "reg [3:0] s; always @(posedge clk) if (rst) s <= 1; else case (1) s[0]: if (a)"
                " s <= 2; s[1]: s <= a ? 4 : 1; s[2]: s <= a ? 8 : 1; s[3]: if (!a) s <= 1;"
                " endcase assign y = s[3];"));
  expect_equal(module_of(", output [5:0] q",
                         "reg [5:0] b; always @(posedge clk) if (rst) b <= 0; else b <= b + 1;"
                         " assign q = b ^ (b >> 1);"),
               module_of(", output reg [5:0] q",
                         "reg [5:0] b; integer i; always @* begin b[5] = q[5];"
                         " for (i = 4; i >= 0; i = i - 1) b[i] = b[i+1] ^ q[i]; end"
                         " wire [5:0] n = b + 1;"
                         " always @(posedge clk) if (rst) q <= 0; else q <= n ^ (n >> 1);"));
}

TEST(Equiv, FindsARegisterThatMoved) {
  expect_equal(
      module_of(", input [7:0] a, b, output [8:0] q",
                "reg [7:0] x, y; always @(posedge clk) begin x <= a; y <= b; end"
                " assign q = x + y;"),
      module_of(", input [7:0] a, b, output reg [8:0] q", "always @(posedge clk) q <= a + b;"));
}

TEST(Equiv, AFifoAsMemoryAndAsShiftRegister) {
  const std::string ports = ", input push, pop, input [1:0] d, output [1:0] q, output empty, full";
  const std::string memory =
      "reg [1:0] m[0:3]; reg [2:0] w, r; assign empty = w == r, full = w == {~r[2], r[1:0]};"
      " assign q = empty ? 0 : m[r[1:0]]; always @(posedge clk) if (rst) begin w <= 0; r <= 0; end"
      " else begin if (push && !full) begin m[w[1:0]] <= d; w <= w + 1; end"
      " if (pop && !empty) r <= r + 1; end";
  const std::string shift =
      "reg [1:0] s0, s1, s2, s3; reg [2:0] n; assign empty = n == 0, full = n == 4; assign q ="
      " n == 0 ? 0 : n == 1 ? s0 : n == 2 ? s1 : n == 3 ? s2 : s3; wire pu = push && !full, po = "
      "pop && !empty; always @(posedge clk)"
      " if (rst) n <= 0; else begin if (pu) begin s0 <= d; s1 <= s0; s2 <= s1;"
      " s3 <= s2; end n <= n + pu - po; end";
  expect_equal(module_of(ports, memory), module_of(ports, shift));
}

TEST(Equiv, ADifferenceFarFromResetIsFound) {
  const auto rtl = [](const std::string& y) {
    return module_of(", output y",
                     "reg [11:0] n; always @(posedge clk) if (rst) n <= 0; else n <= n + 1;"
                     " assign y = " +
                         y + ";");
  };
  // The counter is 0 on the first clock after those of the reset, 0 to 2, and 4095 so many later.
  expect_different(rtl("0"), rtl("&n"), "different on clock 4098");
}

TEST(Equiv, AnXOfTheOldAllowsAnyAndOneOfTheNewMustBeRightForBoth) {
  const auto rtl = [](const std::string& other) {
    return module_of(", input s, output reg [1:0] q",
                     "always @(posedge clk) if (s) q <= 1; else q <= " + other + ";");
  };
  expect_equal(rtl("2'bx"), rtl("0"));
  expect_equal(rtl("2'bx"), rtl("2'bx"));
  expect_different(rtl("0"), rtl("2'bx"), "q is");
}

TEST(Equiv, AnXIsAnyValueHoweverRareAndNoMoreThanThat) {
  const auto rtl = [](const std::string& y) {
    return module_of(", input d, output reg y",
                     "reg [15:0] x, z; always @(posedge clk) begin x <= 16'bx; z <= x;"
                     " y <= " +
                         y + "; end");
  };
  expect_equal(rtl("x == 16'ha5c3"), rtl("1"));
  // Here the values would have to be others on every clock, which is not tried: it is said.
  expect_said(3, rtl("x == 16'ha5c3 && z == 16'h1234"), rtl("d"), "what the old RTL leaves x");
  expect_different(rtl("d ^ (x == x)"), rtl("d"), "y is ");
  expect_different(rtl("d & (x[0] | ~x[0])"), rtl("1"), "y is 1, was 0");
}

TEST(Equiv, OutputsThatAreOneNetAreAllCompared) {
  const std::string one = module_of(", input d, output y, z", "assign y = d, z = d;");
  const auto other = [](const std::string& y, const std::string& z) {
    return module_of(", input d, output y, z", "assign y = " + y + ", z = " + z + ";");
  };
  expect_equal(one, other("d", "~~d"));
  expect_different(other("~d", "d"), one, "y is ");
  expect_different(other("d", "~d"), one, "z is ");
}

TEST(Equiv, AMemoryThatGetsTheSameIsOne) {
  const auto rtl = [](const std::string& name, const std::string& words, const std::string& data) {
    return module_of(", input we, input [11:0] w, r, input [31:0] d, output reg [31:0] q",
                     "reg [31:0] " + name + "[0:" + words +
                         "]; always @(posedge clk) begin if (we) " + name + "[w] <= " + data +
                         "; q <= " + name + "[r]; end");
  };
  expect_said(0, rtl("store", "4095", "d + 1"), rtl("store", "4095", "1 + d"),
              "by memories that get the same");
  expect_different(rtl("store", "3", "d"), rtl("store", "3", "d & ~8"), "q is ");
  // Of another name it holds other values before anything is written; those of the old are x.
  expect_equal(rtl("store", "1", "d"), rtl("other", "1", "d"));
}

// To make registers of it would take minutes.
TEST(Equiv, ADifferenceThatNoMemoryIsPartOf) {
  const auto rtl = [](const std::string& writes, const std::string& counts) {
    return module_of(
        ", input we, input [11:0] w, r, input [31:0] d, output reg [31:0] q, "
        "output reg [2:0] n",
        "reg [31:0] store[0:4095]; always @(posedge clk) begin if (" + writes +
            ") store[w] <= d; q <= store[r]; n <= rst ? 0 : n + " + counts + "; end");
  };
  expect_different(rtl("we", "we"), rtl("we && n != 5", "(we && n != 7)"), "n is ");
}

TEST(Equiv, WhatIsReadIsAnyValueOnlyIfTheMemoryHoldsIt) {
  const auto rtl = [](const std::string& value) {
    return module_of(
        ", input [1:0] w, input r, d, output reg q, p",
        "reg store[0:3]; wire x = store[{r, 1'b0}]; initial begin store[0] = 0; "
        "store[1] = 0; store[2] = 0; store[3] = 0; {p, q} = 0; end always @(posedge clk) begin "
        "store[w | 1] <= d; p <= x; q <= " +
            value + "; end");
  };
  expect_equal(rtl("x"), rtl("0"));
}

// What counts is what they leave in it, not how many statements write it.
TEST(Equiv, AMemoryIsOneHoweverManyPortsWriteIt) {
  const auto rtl = [](const std::string& writes) {
    return module_of(
        ", input we, sel, input [11:0] w, v, r, input [31:0] d, output reg [31:0] q",
        "reg [31:0] store[0:4095]; always @(posedge clk) begin " + writes + " q <= store[r]; end");
  };
  const std::string one = rtl("if (we) store[sel ? v : w] <= sel ? ~d : d;");
  const std::string two = rtl("if (we && sel) store[v] <= ~d; if (we && !sel) store[w] <= d;");
  expect_said(0, one, two, "by memories that get the same");
  // The last one that writes decides.
  const auto small = [&](const std::string& writes) {
    std::string text = rtl(writes);
    return text.replace(text.find("4095"), 4, "3");
  };
  expect_equal(small("store[w] <= d; store[v] <= 0;"),
               small("if (w != v) store[w] <= d; store[v] <= 0;"));
  expect_different(small("store[w] <= d; store[v] <= 0;"), small("store[v] <= 0; store[w] <= d;"),
                   "q is ");
  expect_different(small("if (we) store[w] <= d;"),
                   small("if (we && sel) store[w] <= d; if (we && !sel) store[w] <= d & ~8;"),
                   "q is ");
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

TEST(Equiv, WhatIsBeforeTheEndOfTheResetIsNotCompared) {
  const auto rtl = [](const std::string& first) {
    return module_of(", output reg [3:0] q", "initial q = " + first +
                                                 "; always @(posedge clk) if (rst) q <= 0;"
                                                 " else q <= q + 1;");
  };
  expect_equal(rtl("3"), rtl("9"));
  expect_different(rtl("3"), rtl("9"), "clock 0", {"--reset-clocks", "0"});
}

TEST(Equiv, WhatReadsTheClockIsSeenOnEitherSideOfItsEdge) {
  const auto rtl = [](const std::string& edge, const std::string& d, const std::string& y) {
    return module_of(", input d, output reg q, output y",
                     "always @(" + edge + " clk) q <= " + d + "; assign y = " + y + ";");
  };
  expect_equal(rtl("posedge", "d", "clk & d"), rtl("posedge", "d", "~(~clk | ~d)"));
  expect_different(rtl("posedge", "d", "clk & d"), rtl("posedge", "d", "0"), "y is 0, was 1");
  expect_different(rtl("negedge", "d", "clk & d"), rtl("negedge", "d", "d"), "y is 1, was 0");
  // A register takes over what is there before the edge.
  expect_equal(rtl("posedge", "d | clk", "d"), rtl("posedge", "d", "d"));
  expect_equal(rtl("negedge", "d & clk", "d"), rtl("negedge", "d", "d"));
}

TEST(Equiv, OutputsThatComeLater) {
  const std::string ports = ", input d, output reg q";
  const std::string once = module_of(ports, "always @(posedge clk) q <= rst ? 0 : d;");
  const std::string twice =
      module_of(ports, "reg p; always @(posedge clk) begin p <= rst ? 0 : d; q <= p; end");
  expect_different(once, twice, "q is");
  expect_equal(once, twice, {"--latency", "1"});
}

}  // namespace
}  // namespace cosim::cli
