// cosim equiv: pairs of which it is known whether they are the same, and what it refuses.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
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
  Arguments quick = more;
  quick.emplace_back("--netlists");
  const Ended ended = equiv(gold, gate, quick);
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

// One value of 65536 makes the old output 1: few that are tried would. With x of several clocks,
// and where what is x makes no difference.
TEST(Equiv, AnXIsAnyValueHoweverRareAndNoMoreThanThat) {
  const auto rtl = [](const std::string& y) {
    return module_of(", input d, output reg y",
                     "reg [15:0] x, z; always @(posedge clk) begin x <= 16'bx; z <= x;"
                     " y <= " +
                         y + "; end");
  };
  expect_equal(rtl("x == 16'ha5c3"), rtl("1"));
  // Here the values would have to be others on every clock, which is not tried: it is said.
  const Ended open = equiv(rtl("x == 16'ha5c3 && z == 16'h1234"), rtl("d"));
  EXPECT_EQ(open.status, 3) << open.out << open.err;
  EXPECT_NE(open.out.find("what the old RTL leaves x"), std::string::npos) << open.out;
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

// 4096 words of 32 bits, which would be 131072 registers.
TEST(Equiv, AMemoryThatGetsTheSameIsOne) {
  const auto rtl = [](const std::string& name, const std::string& words, const std::string& data) {
    return module_of(", input we, input [11:0] w, r, input [31:0] d, output reg [31:0] q",
                     "reg [31:0] " + name + "[0:" + words +
                         "]; always @(posedge clk) begin if (we) " + name + "[w] <= " + data +
                         "; q <= " + name + "[r]; end");
  };
  const Ended ended = equiv(rtl("store", "4095", "d + 1"), rtl("store", "4095", "1 + d"));
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("by memories that get the same"), std::string::npos) << ended.out;
  expect_different(rtl("store", "3", "d"), rtl("store", "3", "d & ~8"), "q is ");
  // Of another name it holds other values before anything is written; those of the old are x.
  expect_equal(rtl("store", "1", "d"), rtl("other", "1", "d"));
}

TEST(Equiv, AFileOfAMemoryIsFoundBesideTheRtl) {
  const Folder folder;
  const std::string rom = module_of(", input [1:0] a, output [7:0] q",
                                    "reg [7:0] m[0:3]; initial $readmemh(\"rom.hex\", m);"
                                    " assign q = m[a];");
  for (const char* side : {"old", "same", "new"}) {
    std::filesystem::create_directory(folder.path(side));
    folder.write(side + std::string("/rom.hex"),
                 side == std::string("new") ? "1 2 3 5\n" : "1 2 3 4\n");
    folder.write(side + std::string("/m.v"), rom);
  }
  const auto against = [&](const char* side) {
    return cosim({"equiv", "--gold", folder.path("old/m.v"), "--gate", folder.path(side) + "/m.v",
                  "--top", "m", "--failures", folder.path("kept")});
  };
  EXPECT_EQ(against("same").status, 0);
  const Ended other = against("new");
  EXPECT_EQ(other.status, 1) << other.err;
  EXPECT_NE(other.out.find("q is 00000101, was 00000100"), std::string::npos) << other.out;
}

TEST(Equiv, ATimeThatIsOverIsNoError) {
  const auto rtl = [](const std::string& product) {
    return module_of(", input [47:0] a, b, output [95:0] y", "assign y = " + product + ";");
  };
  const Ended ended = equiv(rtl("a * b"), rtl("b * (a - 1) + b"), {"--seconds", "1"});
  EXPECT_EQ(ended.status, 3) << ended.out << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_NE(ended.out.find("m: undecided"), std::string::npos) << ended.out;
}

TEST(Equiv, AReportThatCannotBeWrittenIsRefusedFirst) {
  const std::string rtl = module_of(", input d, output q", "assign q = d;");
  const Ended ended = equiv(rtl, rtl, {"--report", "/no/such/folder/report.json"});
  expect_refused(ended, "/no/such/folder");
  EXPECT_EQ(ended.out, "");
}

// Registers, a parameter, a tied input, a port of another name and a clock that falls.
TEST(EquivReplay, ShowsADifferenceInVerilator) {
  const auto rtl = [](const std::string& name, const std::string& y) {
    return "module m #(parameter W = 2)(input clk, input rst, input off, input [W-1:0] d,"
           " output [W-1:0] " +
           name +
           ");\nreg [W-1:0] a, b; always @(negedge clk) if (rst) {a, b} <= 0; else begin"
           " a <= #1 d; b <= #1 a; end assign " +
           name + " = " + y + ";\nendmodule\n";
  };
  const Ended ended = equiv(rtl("q", "off ? 0 : b"), rtl("y", "b & ~(b == 9)"),
                            {"--param", "W=4", "--tie", "off=0", "--map", "q=y"});
  EXPECT_EQ(ended.status, 1) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("q is 1000, was 1001; replayed in Verilator\n"), std::string::npos)
      << ended.out;
}

TEST(EquivReplay, ADifferenceThatVerilatorDoesNotShowIsNotClaimed) {
  const std::string one = module_of(", input d, output y", "assign y = d;");
  const std::string two = module_of(", input d, output y",
                                    "`ifdef VERILATOR\nassign y = d;\n`else\nassign y = ~d;\n"
                                    "`endif");
  const Ended ended = equiv(one, two);
  EXPECT_EQ(ended.status, 3) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("undecided: the netlists differ, but not the RTL in Verilator"),
            std::string::npos)
      << ended.out;
}

TEST(Equiv, SaysWhereThereIsNoVerilator) {
  const Folder bin;
  for (const char* program : {"env", "yosys", "yosys-abc"}) {
    const std::string link =
        "ln -s \"$(command -v " + std::string(program) + ")\" '" + bin.path(program) + "'";
    ASSERT_EQ(std::system(link.c_str()), 0);
  }
  const std::string path = std::getenv("PATH");
  setenv("PATH", bin.path("").c_str(), 1);
  const Ended ended = equiv(module_of(", input d, output y", "assign y = d;"),
                            module_of(", input d, output y", "assign y = ~d;"));
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(ended.status, 1) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("replayed on the netlists: there is no Verilator"), std::string::npos)
      << ended.out;
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
  const std::string make = "env -u HOME -u XDG_STATE_HOME yosys -q -p 'read_verilog " + gcd +
                           "; synth -flatten -top m; abc -g AND,XOR,MUX; opt_clean; write_verilog "
                           "-noattr " +
                           netlist + "'";
  ASSERT_EQ(std::system(make.c_str()), 0);
  const Ended ended = cosim({"equiv", "--gold", gcd, "--gate", netlist, "--top", "m"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
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
  const Arguments words{"equiv",      "--rev",      "HEAD",
                        "--top",      "m",          file,
                        "--netlists", "--failures", folder.path("kept")};
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
