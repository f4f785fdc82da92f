// cosim equiv: its files, its time, what it refuses, and the replay in Verilator.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/cli/equiv_pairs.h"

namespace cosim::cli {
namespace {

// A memory that is read from a file beside the RTL, and one that is another there.
void expect_found_beside_the_rtl(const Arguments& more, const std::string& replayed) {
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
    Arguments words{
        "equiv", "--gold", folder.path("old/m.v"), "--gate",           folder.path(side) + "/m.v",
        "--top", "m",      "--failures",           folder.path("kept")};
    return cosim(joined(words, more));
  };
  EXPECT_EQ(against("same").status, 0);
  const Ended other = against("new");
  EXPECT_EQ(other.status, 1) << other.err;
  EXPECT_TRUE(has(other.out, "q is 00000101, was 00000100; " + replayed + '\n'));
}

TEST(Equiv, AFileOfAMemoryIsFoundBesideTheRtl) {
  expect_found_beside_the_rtl({}, "replayed in Icarus Verilog");
}

TEST(Equiv, ATimeThatIsOverIsNoError) {
  const auto rtl = [](const std::string& product) {
    return module_of(", input [47:0] a, b, output [95:0] y", "assign y = " + product + ";");
  };
  const Ended ended = ends(3, equiv(rtl("a * b"), rtl("b * (a - 1) + b"), {"--seconds", "1"}));
  EXPECT_EQ(ended.err, "");
  EXPECT_TRUE(has(ended.out, "m: undecided"));
}

TEST(Equiv, AReportThatCannotBeWrittenIsRefusedFirst) {
  const std::string rtl = module_of(", input d, output q", "assign q = d;");
  const Ended ended = equiv(rtl, rtl, {"--report", "/no/such/folder/report.json"});
  expect_refused(ended, "/no/such/folder");
  EXPECT_EQ(ended.out, "");
}

TEST(EquivReplay, ShowsADifferenceInIcarus) {
  const auto rtl = [](const std::string& name, const std::string& y) {
    return "module m #(parameter W = 2)(input clk, input rst, input off, input [W-1:0] d,"
           " output [W-1:0] " +
           name +
           ");\nreg [W-1:0] a, b; always @(negedge clk) if (rst) {a, b} <= 0; else begin"
           " a <= #1 d; b <= #1 a; end assign " +
           name + " = " + y + ";\nendmodule\n";
  };
  expect_said(1, rtl("q", "off ? 0 : b"), rtl("y", "b & ~(b == 9)"),
              "q is 1000, was 1001; replayed in Icarus Verilog\n",
              {"--param", "W=4", "--tie", "off=0", "--map", "q=y"});
}

// yosys reads one thing, and a simulator of the same source another.
TEST(EquivReferee, RtlThatIsNotReadAsItIsWrittenDecidesNothing) {
  const std::string one = module_of(", input d, output y", "assign y = d;");
  const auto two = [](const char* seen, const char* simulated) {
    return module_of(", input d, output y", std::string("`ifdef __ICARUS__\nassign y = ") +
                                                simulated + ";\n`else\nassign y = " + seen +
                                                ";\n`endif");
  };
  for (const auto& text : {two("d", "~d"), two("~d", "d")}) {
    expect_said(3, one, text, "the new RTL is misread: output y is ");
  }
}

TEST(EquivReferee, WithoutASimulatorNothingIsDecided) {
  const std::string ports = ", input d, output y";
  const Ended ended = with_yosys_alone(
      [&] { return equiv(module_of(ports, "assign y = d;"), module_of(ports, "assign y = ~d;")); });
  EXPECT_EQ(ended.status, 3) << ended.out << ended.err;
  EXPECT_TRUE(has(ended.out, "no simulator runs the old RTL: Icarus Verilog is not installed"));
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

TEST(Equiv, AnInputIsHeldAtAValueOfAnyWidth) {
  const auto rtl = [](const std::string& bits) {
    return module_of(", input [69:0] d, output [69:0] q", "assign q = " + bits + ";");
  };
  expect_equal(rtl("d"), rtl("70'd5"), {"--tie", "d=5"});
  expect_equal(rtl("d"), rtl("70'h3f_8000_0001_0000_0000"), {"--tie", "d=0x3f8000000100000000"});
  expect_different(rtl("d"), rtl("70'd5"), "q is ", {"--tie", "d=4"});
  expect_refused(equiv(rtl("d"), rtl("d"), {"--tie", "d=0x400000000000000000"}),
                 "--tie: 'd' has 70 bits, and the value needs 71");
}

TEST(Equiv, OptionsNamePortsThatThereAre) {
  const std::string rtl =
      module_of(", input d, output reg q", "always @(posedge clk) q <= rst ? 0 : d;");
  expect_refused(equiv(rtl, rtl, {"--tie", "e=1"}), "--tie: 'e' is no input");
  expect_refused(equiv(rtl, rtl, {"--tie", "clk=1"}), "--tie: 'clk' is a clock");
  expect_refused(equiv(rtl, rtl, {"--ignore", "d"}), "--ignore: 'd' is no output");
  expect_refused(equiv(rtl, rtl, {"--map", "e=d"}), "--map: the old RTL has no port 'e'");
  expect_refused(equiv(rtl, rtl, {"--map", "d=e"}), "--map: the new RTL has no port 'e'");
}

// An option that has two values, and a port that would be two.
TEST(Equiv, OptionsThatContradictOneAnotherAreRefused) {
  const std::string rtl = "module m(input a, b, output [1:0] y); assign y = {a, b}; endmodule\n";
  const auto refused = [&](const Arguments& more, const std::string& said) {
    expect_refused(equiv(rtl, rtl, more), said);
  };
  refused({"--tie", "a=0", "--tie", "a=1"}, "--tie: 'a' is given twice, as '0' and as '1'");
  refused({"--map", "a=b", "--map", "a=a"}, "--map: 'a' is given twice, as 'b' and as 'a'");
  refused({"--map", "a=b"}, "--map: 'a' and 'b' of the old RTL are both mapped to 'b' of the new");
  refused({"--define", "A", "--define", "A=2"}, "--define: 'A' is given twice, as '' and as '2'");
  refused({"--reset", "a=0", "--reset", "a=1"}, "--reset: 'a' is given twice");
  refused({"--param", "W=1", "--gold-param", "W=2"},
          "--param and --gold-param: 'W' is given twice");
  expect_equal(rtl, rtl, {"--tie", "a=0", "--tie", "a=0"});
  expect_different(rtl, rtl, "y is ", {"--map", "a=b", "--map", "b=a"});
}

// All that is read: files, their headers and data, and what is there since an older run.
TEST(Equiv, NothingThatIsReadOrIsAPersonsIsWrittenOver) {
  const Folder folder;
  std::filesystem::create_directories(folder.path("inc"));
  std::filesystem::create_directories(folder.path("kept/m-equiv"));
  folder.write("inc/m.vh", "`define W 2\n");
  folder.write("m.hex", "0 1\n");
  folder.write("cells.v", "");
  folder.write("m.v",
               "`include \"m.vh\"\nmodule m(input a, output [`W-1:0] y); reg [`W-1:0] m[0:1];\n"
               "initial $readmemh(\"m.hex\", m); assign y = m[a]; endmodule\n");
  const Arguments command{"equiv",
                          "--gold",
                          folder.path("m.v"),
                          "--gate",
                          folder.path("m.v"),
                          "--cells",
                          folder.path("cells.v"),
                          "--include",
                          folder.path("inc"),
                          "--top",
                          "m",
                          "--failures",
                          folder.path("kept")};
  for (const char* file : {"m.v", "cells.v", "inc/m.vh", "m.hex"}) {
    for (const char* option : {"--report", "--junit"}) {
      const std::string before = folder.text(file);
      expect_refused(cosim(joined(command, {option, folder.path(file)})),
                     std::string(option) + ": " + folder.path(file) + " is the file that is read");
      EXPECT_EQ(folder.text(file), before);
    }
  }
  EXPECT_EQ(ends(0, cosim(command)).err, "");
  folder.write("kept/m-equiv/notes", "mine");
  expect_refused(cosim(command), "m-equiv: has notes, which is not from an earlier run");
}

// What goes to its pins is compared, and what comes from them is any value, the same in both.
TEST(Equiv, AModuleThatNoFileHas) {
  const auto rtl = [](const std::string& to, const std::string& from) {
    return module_of(", input [1:0] d, output reg q",
                     "wire o; wire [1:0] w = " + to +
                         "; PAD pad(.I(w), .O(o)); always @(posedge clk) q <= " + from + ";");
  };
  const std::string one = rtl("d + 1", "o ^ d[0]");
  expect_refused(equiv(one, one), "Give a file that has it, or --blackbox PAD");
  const Arguments box{"--blackbox", "PAD"};
  expect_equal(one, rtl("{d[1] ^ d[0], ~d[0]}", "d[0] ? ~o : o"), box);
  expect_different(one, rtl("d - 1", "o ^ d[0]"), "pad$I is ", box);
  expect_different(one, rtl("d + 1", "o | d[0]"), "q is ", box);
  expect_refused(equiv(one, module_of(", input [1:0] d, output reg q", ""), box),
                 "PAD: a blackbox that m has no instance of");
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
                    "reg p; always @(posedge clk) p <= d; always @(negedge clk) q <= p;"),
          "both edges of clk are used");
  refused(module_of(", input d, output reg q", "wire c = clk & d; always @(posedge c) q <= d;"),
          "a clock that is no input");
  refused(module_of(", input d, inout q", "wire a; assign {a, q} = d ? 2'b0 : 2'bz;"),
          "q: an inout port that is driven in a part of { }");
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

// Each option takes one value: the file behind it is none.
TEST(Equiv, AnOptionDoesNotTakeTheFileBehindIt) {
  const Folder folder;
  const std::string file = folder.write(
      "m.v",
      "module m #(parameter W = 1, V = 1) (input [W-1:0] a, input [V-1:0] b, input off, other, "
      "output y, z); assign y = ^a & off, z = ^b & other; endmodule\n");
  const std::string git = "git -C '" + folder.path("") + "' -c user.name=n -c user.email=e ";
  ASSERT_EQ(std::system((git + "init -q && " + git + "add m.v && " + git + "commit -qm x").c_str()),
            0);
  const std::vector<Arguments> all{
      {"--tie", "off=0", "--tie", "other=1"},  {"--param", "W=4", "--param", "V=2"},
      {"--ignore", "y", "--ignore", "z"},      {"--define", "X", "--define", "Y=1"},
      {"--include", folder.path("")},          {"--map", "y=y", "--map", "z=z"},
      {"--assume", "off", "--assume", "other"}};
  for (const Arguments& options : all) {
    const Ended ended =
        cosim(joined(joined({"equiv", "--rev", "HEAD", "--top", "m"}, options), {file}));
    EXPECT_EQ(ended.status, 0) << options.front() << ended.out << ended.err;
  }
}

}  // namespace
}  // namespace cosim::cli
