// cosim equiv: pairs of which it is known whether they are the same, and what it refuses.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/cli/folder.h"
#include "tests/cli/program.h"

namespace cosim::cli {
namespace {

// `body` behind a clock, a reset and `ports`.
std::string module_of(const std::string& ports, const std::string& body) {
  return "module m(input clk, input rst" + ports + ");\n" + body + "\nendmodule\n";
}

Ended equiv(const std::string& gold, const std::string& gate, Arguments more = {},
            const std::string& top = "m") {
  const Folder folder;
  Arguments words{"equiv",
                  "--gold",
                  folder.write("gold.v", gold),
                  "--gate",
                  folder.write("gate.v", gate),
                  "--top",
                  top,
                  "--failures",
                  folder.path("kept")};
  words.insert(words.end(), more.begin(), more.end());
  Ended ended = cosim(words);
  // What is kept belongs to a difference alone.
  EXPECT_EQ(folder.holds("kept"), ended.status == 1) << ended.out;
  return ended;
}

void expect_equal(const std::string& gold, const std::string& gate, const Arguments& more = {}) {
  const Ended ended = equiv(gold, gate, more);
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("m: equal for ever"), std::string::npos) << ended.out;
}

void expect_different(const std::string& gold, const std::string& gate, const std::string& said,
                      const Arguments& more = {}) {
  const Ended ended = equiv(gold, gate, more);
  EXPECT_EQ(ended.status, 1) << ended.out << ended.err;
  EXPECT_NE(ended.out.find(said), std::string::npos) << ended.out;
}

void expect_refused(const Ended& ended, const std::string& said) {
  EXPECT_EQ(ended.status, 2) << ended.out;
  EXPECT_EQ(lines(ended.err).size(), 1U) << ended.err;
  EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
}

TEST(Equiv, IsTheSameWithItself) {
  const std::string shift =
      module_of(", input d, output q",
                "reg [4:0] s; always @(posedge clk) s <= {s[3:0], d}; assign q = s[4];");
  expect_equal(shift, shift);
  const std::string by =
      module_of(", input signed [15:0] a, input [3:0] n, output reg signed [15:0] q",
                "reg [3:0] m; always @(posedge clk) begin m <= n; q <= a >>> m; end");
  expect_equal(by, by);
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
      "reg [1:0] m[0:1]; reg [1:0] w, r; assign empty = w == r, full = w == {~r[1], r[0]};"
      " assign q = empty ? 0 : m[r[0]]; always @(posedge clk) if (rst) begin w <= 0; r <= 0; end"
      " else begin if (push && !full) begin m[w[0]] <= d; w <= w + 1; end"
      " if (pop && !empty) r <= r + 1; end";
  const std::string shift =
      "reg [1:0] s0, s1, n; assign empty = n == 0, full = n == 2; assign q = empty ? 0 : n == 1 ? "
      "s0 : s1; wire pu = push && !full, po = pop && !empty; always @(posedge clk)"
      " if (rst) n <= 0; else begin if (pu) begin s0 <= d; s1 <= s0; end n <= n + pu - po; end";
  expect_equal(module_of(ports, memory), module_of(ports, shift));
}

TEST(Equiv, ADifferenceFarFromResetIsFound) {
  const auto rtl = [](const std::string& y) {
    return module_of(", output y",
                     "reg [11:0] n; always @(posedge clk) if (rst) n <= 0; else n <= n + 1;"
                     " assign y = " +
                         y + ";");
  };
  // The counter is 0 after three clocks of reset, and 4095 so many clocks later.
  expect_different(rtl("0"), rtl("&n"), "different on clock 4099");
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

TEST(Equiv, WhatIsBeforeTheEndOfTheResetIsNotCompared) {
  const auto rtl = [](const std::string& first) {
    return module_of(", output reg [3:0] q", "initial q = " + first +
                                                 "; always @(posedge clk) if (rst) q <= 0;"
                                                 " else q <= q + 1;");
  };
  expect_equal(rtl("3"), rtl("9"));
  expect_different(rtl("3"), rtl("9"), "clock 1", {"--reset-clocks", "0"});
}

TEST(Equiv, OutputsThatComeLater) {
  const std::string ports = ", input d, output reg q";
  const std::string once = module_of(ports, "always @(posedge clk) q <= rst ? 0 : d;");
  const std::string twice =
      module_of(ports, "reg p; always @(posedge clk) begin p <= rst ? 0 : d; q <= p; end");
  expect_different(once, twice, "q is");
  expect_equal(once, twice, {"--latency", "1"});
}

TEST(Equiv, PortsThatOneSideLacksAreTiedIgnoredOrRenamed) {
  const std::string one = module_of(", input d, output q", "assign q = d;");
  const std::string two =
      module_of(", input d, input off, output y, output more", "assign y = d & ~off, more = off;");
  expect_refused(equiv(one, two),
                 "the ports differ: off only in the new, q only in the old, more only in the new, "
                 "y only in the new; write --tie INPUT=VALUE, --ignore OUTPUT or --map OLD=NEW");
  expect_equal(one, two, {"--map", "q=y", "--tie", "off=0", "--ignore", "more"});
  expect_different(one, two, "q is 0, was 1",
                   {"--map", "q=y", "--tie", "off=1", "--ignore", "more"});
}

TEST(Equiv, RefusesWhatItCannotCompareInALine) {
  const std::string good = module_of(", input d, output reg q", "always @(posedge clk) q <= d;");
  const auto refused = [&](const std::string& rtl, const std::string& said) {
    expect_refused(equiv(good, rtl), said);
  };
  refused(module_of(", input d, output reg q", "always @* if (rst) q = d;"), "a latch");
  refused(module_of(", input d, output q", "wire a, b; assign a = b ^ d, b = ~a, q = a;"),
          "a combinational loop");
  refused(module_of(", input d, output reg q",
                    "reg p; always @(posedge clk) p <= d; always @(posedge rst) q <= p;"),
          "two clocks");
  refused(module_of(", input d, output reg q", "wire c = clk & d; always @(posedge c) q <= d;"),
          "a clock that is no input");
  refused(module_of(", input d, inout q", ""), "port q is inout");
  refused("module m(\n  input clk, rst ;\n", "gate.v:2");
  expect_refused(equiv(good, good, {}, "other"), "other");
  expect_refused(equiv(good, good, {}, "m; shell touch x"), "is no name of Verilog");
  expect_refused(equiv(good, good, {"--param", "W=1;shell"}), "--param: 'W=1;shell'");
  expect_refused(equiv(good, good, {"--define", "A -p"}), "--define: 'A -p'");
  expect_refused(equiv(good, good, {"--reset", "none"}), "--reset: 'none' is no input of one bit");
  expect_refused(cosim({"equiv", "--gold", "/no/such.v", "--gate", "/no/such.v", "--top", "m"}),
                 "/no/such.v");
}

TEST(Equiv, ARevisionAgainstTheFilesOnDisk) {
  const Folder folder;
  const auto rtl = [](const std::string& d) {
    return module_of(", input d, output reg q", "always @(posedge clk) q <= " + d + ";");
  };
  const std::string file = folder.write("m.v", rtl("d"));
  const std::string git = "git -C '" + folder.path("") + "' -c user.name=n -c user.email=e ";
  ASSERT_EQ(std::system((git + "init -q && " + git + "add m.v && " + git + "commit -qm x").c_str()),
            0);
  const Arguments words{"equiv", "--rev", "HEAD",       "--top",
                        "m",     file,    "--failures", folder.path("kept")};
  folder.write("m.v", rtl("d & d"));
  EXPECT_EQ(cosim(words).status, 0);
  folder.write("m.v", rtl("!d"));
  EXPECT_EQ(cosim(words).status, 1);
  Arguments no_such = words;
  no_such[2] = "nothing";
  expect_refused(cosim(no_such), "--rev: 'nothing' is no revision");
}

}  // namespace
}  // namespace cosim::cli
