// Bad input: one line on standard error that says what is wrong, status 2, and no file touched.
// Needs: linear, circular, toolpath
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/cli/help.h"
#include "tests/cli/program.h"
#include "tests/support/root.h"

namespace cosim::cli {
namespace {

using Refusal = InAFolder;

// Runs the command, with outputs where `writes`, and expects that error.
void expect_refused(Arguments command, const std::string& error, bool writes = true) {
  std::string shown;
  for (const std::string& a : command) shown += a + " ";
  SCOPED_TRACE(shown);
  const Folder folder;
  const std::string kept = "kept\n";
  if (writes && !command.empty()) {
    if (command.front() != "sweep") {
      command.insert(command.end(), {"--csv", folder.write("csv", kept)});
    }
    command.insert(command.end(), {"--report", folder.write("report", kept)});
  }
  const Ended ended = ends(2, cosim(command));
  EXPECT_EQ(ended.err, "cosim: " + error + "\n");
  if (!command.empty()) EXPECT_EQ(ended.out, "");
  if (!writes) return;
  EXPECT_EQ(folder.text("report"), kept);
  if (command.front() != "sweep") EXPECT_EQ(folder.text("csv"), kept);
}

void expect_unused(const Arguments& command, const std::string& error) {
  expect_refused(command, error, false);
}

const std::string kTo32Bits = " is not a whole number from 0 to 4294967295";

TEST_F(Refusal, OfCommands) {
  const std::string commands = names_of_commands();
  EXPECT_TRUE(
      commands.starts_with("list, ") &&
      commands.ends_with(", sweep, replay, wave, cover, prove, mutate, regress, lint, equiv, new"));
  const std::string designs = names_of_commands({"sweep"});
  expect_unused({}, "a command is needed: " + commands);
  expect_unused({"draw"}, "no such command: 'draw'; there are " + commands);
  expect_unused({"linear"}, "linear is a design: a command comes before it: " + commands);
  expect_unused({""}, "no such command: ''; there are " + commands);
  expect_unused({"--csv", "x"}, "no such option: '--csv'");
  expect_unused({"list", "line"}, "list: takes no 'line'");
  expect_unused({"list", "--csv", "x"}, "list: no such option: '--csv'");
  expect_unused({"sweep"}, "sweep: a design is needed: " + designs);
  expect_unused({"sweep", "spiral"}, "sweep: no such design: 'spiral'; there are " + designs);
  expect_unused({"sweep", "--random", "5"},
                "sweep: --random comes behind the design: sweep linear --random");
  expect_unused({"sweep", "--randoms", "5"}, "sweep: no such option: '--randoms'");
  expect_unused({"sweep", "linear", "circular"}, "sweep linear: takes no 'circular'");
  expect_unused({"sweep", "linear", "M=7"},
                "sweep linear: takes no 'M=7': it runs every configuration");
}

TEST_F(Refusal, OfProofs) {
  expect_unused({"prove", "spiral"}, "'spiral' is not built; see cosim list");
  expect_unused({"prove", "linear", "M=7"}, "'linear M=7' is not built; see cosim list");
  expect_unused({"prove", "--limit", "0"}, "--limit: '0' is not a whole number from 1 to 86400");
  expect_unused({"prove", "--count", "5"}, "--count: belongs to --mutants");
  expect_unused({"prove", "--mutant", "5"}, "--mutant: belongs to --mutants");
  expect_unused({"prove", "--theorems", "spiral"}, "spiral: is no design with theorems");
  expect_unused({"prove", "linear", "--rtl", "/dev/null"},
                "/dev/null: no Verilog of linear; --rtl DIR names the folder that has it");
}

TEST_F(Refusal, OfOptions) {
  const Arguments line{"line", "--major", "27", "--minor", "9"};
  const auto with = [&](const Arguments& more) { return joined(line, more); };
  expect_refused(with({"--length", "5"}), "line: no such option: '--length'");
  expect_refused(with({"--maj", "5"}), "line: no such option: '--maj'");
  expect_refused(with({"-5"}), "line: no such option: '-5'");
  expect_refused(with({"more"}), "line: takes no 'more'");
  expect_refused(with({"arc"}), "line: takes no 'arc'");
  expect_refused(with({"--minor", "9"}), "--minor: is given more than once");
  expect_refused(with({"--table=no"}), "--table: takes no value");
  expect_unused(with({"--csv"}), "--csv: needs a value");
  expect_unused(with({"--csv", "--table"}), "--csv: needs a value");
  expect_unused(with({"--csv", "--seed", "5"}), "--csv: needs a value");
  expect_unused(with({"--csv=", "x"}), "--csv: needs a value");
  expect_unused(with({"--csv", ""}), "--csv: names no file");
  expect_unused(with({"--report", ""}), "--report: names no file");
  expect_refused(with({"--jobs", "2"}), "line: no such option: '--jobs'");
  for (const std::string seed : {"", "-1", "x", "1.5", "18446744073709551616"}) {
    expect_refused(with({"--seed", seed}),
                   "--seed: '" + seed + "' is not a whole number from 0 to 18446744073709551615");
  }
}

TEST_F(Refusal, OfNumbersThatAreNone) {
  for (const std::string n :
       {"", " ", "x", "-1", "-0", "+1", "1.5", "1e3", "1e999", "nan", "inf", "0x10", "1 ", " 1",
        "1,000", "4294967296", "99999999999999999999999"}) {
    const std::string what = "'" + n + "'" + kTo32Bits;
    expect_refused({"line", "--major", n, "--minor", "0"}, "--major: " + what);
    expect_refused({"line", "--major", "5", "--minor", n}, "--minor: " + what);
    expect_refused({"arc", "--radius", n}, "--radius: " + what);
  }
  expect_refused({"line", "--minor", "0", "--major", std::string(100000, '9')},
                 "--major: '" + std::string(40, '9') + "...'" + kTo32Bits);
  expect_refused({"line", "--minor", "0", "--major", "1\n2\x1b[31m"},
                 "--major: '1?2?[31m'" + kTo32Bits);
}

TEST_F(Refusal, OfLines) {
  expect_refused({"line"}, "--major: is needed");
  expect_refused({"line", "--minor", "3"}, "--major: is needed");
  expect_refused({"line", "--major", "3"}, "--minor: is needed where --code gives no bits");
  expect_refused({"line", "--major", "5", "--minor", "6"},
                 "--minor: 6 is more than --major 5 (MP <= BP)");
}

TEST_F(Refusal, OfMachinesNotBuilt) {
  const Arguments line{"line", "--major", "40", "--minor", "3"};
  const auto with = [&](const Arguments& more) { return joined(line, more); };
  const std::string built =
      " was not built; built are M=5 N=2, M=6 N=3, M=8 N=5, M=16 N=12, M=16 N=13, M=24 N=21, "
      "M=32 N=26";
  expect_refused(with({"--m", "7"}), "linear M=7" + built);
  expect_refused(with({"--n", "7"}), "linear N=7" + built);
  expect_refused(with({"--m", "5", "--n", "3"}), "linear M=5 N=3" + built);
  expect_refused(with({"--m", "5"}),
                 "a line of 40 major steps does not fit linear M=5 N=2: BP < 2^5");
  for (const std::string m : {"", "0", "1", "33", "-5", "99999999999999999999"}) {
    expect_refused(with({"--m", m}), "--m: '" + m + "' is not a whole number from 2 to 32");
  }
  expect_refused(with({"--n", "0"}), "--n: '0' is not a whole number from 1 to 32");
  expect_refused({"arc", "--radius", "12", "--width", "5"},
                 "circular W=5 was not built; built are W=4, W=8, W=12, W=16, W=24, W=32");
  for (const std::string w : {"", "0", "1", "33", "nan"}) {
    expect_refused({"arc", "--radius", "1", "--width", w},
                   "--width: '" + w + "' is not a whole number from 2 to 32");
  }
  expect_refused({"arc", "--radius", "16", "--width", "4"},
                 "an arc that needs 5 bits does not fit circular W=4");
}

TEST_F(Refusal, OfCodes) {
  for (const std::string code : {"", "0101", "0101000", "10", "1", "0", "12345", "0b01010", "0x",
                                 "0x20", "-1010", "0x-1", "Best", "01O10"}) {
    expect_refused({"line", "--major", "27", "--minor", "9", "--code", code},
                   "--code: '" + code + "' is not best, greedy, 5 bits (M=5) or 0x0 to 0x1f");
  }
  expect_refused({"line", "--major", "27", "--minor", "9", "--code", "01011"},
                 "--code: '01011' gives 10 minor steps on a line of 27, not 9");
  expect_refused({"line", "--major", "27", "--minor", "9", "--code", "00001"},
                 "--code: '00001' gives 1 minor step on a line of 27, not 9");
}

TEST_F(Refusal, OfArcs) {
  const auto arc = [](const Arguments& more) { return joined({"arc", "--radius", "12"}, more); };
  expect_refused({"arc"}, "--radius: is needed, or --radius2");
  expect_refused(arc({"--radius2", "144"}), "--radius: does not go with --radius2");
  for (const std::string q : {"", "-1", "1e9", "18446744065119617026", "18446744073709551616"}) {
    expect_refused({"arc", "--radius2", q},
                   "--radius2: '" + q + "' is not a whole number from 0 to 18446744065119617025");
  }
  for (const std::string from : {"", "3", "3,4,5", "12,0,", "12;0"}) {
    expect_refused(arc({"--from", from}), "--from: '" + from + "' is not X,Y");
  }
  expect_refused(arc({"--from", ","}), "--from: X: ''" + kTo32Bits);
  expect_refused(arc({"--from", "12,"}), "--from: Y: ''" + kTo32Bits);
  expect_refused(arc({"--from", "-1,4"}), "--from: X: '-1'" + kTo32Bits);
  expect_refused(arc({"--from=-1,4"}), "--from: X: '-1'" + kTo32Bits);
  expect_refused(arc({"--from", "12,4294967296"}), "--from: Y: '4294967296'" + kTo32Bits);
  const std::string off = " is not next to the circle of R^2 = 144";
  expect_refused(arc({"--from", "3,4"}), "--from: (3, 4)" + off + "; (3, 12) is");
  expect_refused(arc({"--from", "11,0"}), "--from: (11, 0)" + off + "; (12, 0) is");
  expect_refused(arc({"--from", "13,13"}), "--from: (13, 13)" + off);
  expect_refused(arc({"--from", "4294967295,4294967295"}),
                 "--from: (4294967295, 4294967295)" + off);
  for (const std::string count : {"", "-1", "1.5", "1099511627777", "99999999999999999999"}) {
    expect_refused(arc({"--count", count}),
                   "--count: '" + count + "' is not a whole number from 0 to 1099511627776");
  }
}

TEST_F(Refusal, OfSweeps) {
  const std::string one = "sweep: one of --exhaustive, --random and --hostile is needed, ";
  expect_refused({"sweep", "linear"}, one + "none is given");
  expect_refused({"sweep", "linear", "--exhaustive", "--random", "5"}, one + "more are given");
  expect_refused({"sweep", "linear", "--random", "5", "--hostile", "5"}, one + "more are given");
  expect_refused({"sweep", "circular", "--exhaustive", "--hostile", "5"}, one + "more are given");
  expect_refused({"sweep", "circular", "--random", "5", "--random", "6"},
                 "--random: is given more than once");
  for (const std::string n : {"", "0", "-1", "nan", "1e3", "281474976710657"}) {
    const std::string what = ": '" + n + "' is not a whole number from 1 to 281474976710656";
    expect_refused({"sweep", "linear", "--random", n}, "--random" + what);
    expect_refused({"sweep", "circular", "--hostile", n}, "--hostile" + what);
  }
  for (const std::string n : {"", "0", "-1", "1025", "x"}) {
    expect_refused({"sweep", "linear", "--random", "1", "--jobs", n},
                   "--jobs: '" + n + "' is not a whole number from 1 to 1024");
  }
  expect_refused({"sweep", "linear", "--hostile", "5", "--lanes", "128"},
                 "--lanes: '128' is not auto, gpu, 512, 256, 64 or 0");
  const std::string wide = "--exhaustive: too wide to try everything; take ";
  expect_refused({"sweep", "linear", "--exhaustive", "--m", "16"},
                 wide + "M <= 8, or 14 with --lanes auto");
  expect_refused({"sweep", "circular", "--exhaustive", "--width", "32"},
                 wide + "W <= 12, or 16 with --lanes auto");
  expect_unused({"sweep", "linear", "--random", "1", "--width", "4"},
                "sweep linear: no such option: '--width'");
  expect_unused({"sweep", "linear", "--random", "1", "--csv", "x"},
                "sweep linear: no such option: '--csv'");
}

TEST_F(Refusal, OfScales) {
  const std::string file = folder.write("p.ngc", "G0 X10\n");
  expect_refused({"path", file}, "--steps-per-mm: is needed");
  for (const std::string s :
       {"", "0", "-1", "nan", "inf", "-inf", "1e999", "1e-999", "1e10", "ten", "1x", " 1", "+1"}) {
    expect_refused({"path", file, "--steps-per-mm", s},
                   "--steps-per-mm: '" + s + "' is not a number above 0 and at most 1000000000");
  }
  expect_refused({"path", file, "--steps-per-mm", "1e9"},
                 file + ":1:4: the target is beyond the reach of 2147483647 steps");
  expect_refused({"path", file, "--steps-per-mm", "0.01"},
                 file + ": no motion reaches a step at 0.01 steps/mm");
  expect_refused({"path", file, "--steps-per-mm", "10", "--code", "01010"},
                 "--code: '01010' is not best or greedy");
  expect_refused({"path", file, "--steps-per-mm", "10", "--m", "5"},
                 "a line of 100 major steps does not fit linear M=5 N=2: BP < 2^5");
  expect_refused(
      {"path", folder.write("arc.ngc", "G3 X0 I100\n"), "--steps-per-mm", "10", "--width", "4"},
      "an arc that needs 10 bits does not fit circular W=4");
}

TEST_F(Refusal, OfFiles) {
  const auto path = [](const std::string& file) {
    return Arguments{"path", file, "--steps-per-mm", "10"};
  };
  expect_refused({"path", "--steps-per-mm", "10"}, "FILE: is needed");
  expect_refused(path(""), "FILE: names no file");
  expect_refused({"path", "a", "b", "--steps-per-mm", "10"}, "path: takes no 'b'");
  expect_refused(path(folder.path("none")), folder.path("none") + ": no such file");
  expect_refused(path(folder.path("a\nb\x1b[31m")), folder.path("a?b?[31m") + ": no such file");
  expect_refused(path(folder.path("")), folder.path("") + ": is a directory, not a file");
  ASSERT_EQ(mkfifo(folder.path("pipe").c_str(), 0600), 0);
  expect_refused(path(folder.path("pipe")), folder.path("pipe") + ": is not a regular file");
  expect_refused(path("/dev/null"), "/dev/null: is not a regular file");
  expect_refused(path(COSIM_PROGRAM), COSIM_PROGRAM ":1:1: unexpected byte 0x7f");
  std::string bytes;
  for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * 37 % 256);
  const std::string noise = folder.write("noise", bytes);
  EXPECT_EQ(refusal(cosim(path(noise))).find("cosim: " + noise + ":1:1: "), 0U);
}

TEST_F(Refusal, OfProgramsWithoutMotion) {
  const auto error = [&](const char* program, const std::string& what) {
    const std::string file = folder.write("p.ngc", program);
    expect_refused({"path", file, "--steps-per-mm", "10"}, file + what);
  };
  const std::string none = "the program ends without a motion in X or Y";
  error("", ":1:1: " + none);
  error("G0 Z5\n", ":2:1: " + none);
  error("G0 X0 Y0\nM2\nX5\n", ":2:1: " + none);
}

TEST_F(Refusal, OfWrongPrograms) {
  for (const char* number : {"nan", "inf", "0x10"}) {
    const std::string file = folder.write("p.ngc", std::string("G0 Y1 X") + number + "\n");
    const std::string said = refusal(cosim({"path", file, "--steps-per-mm", "10"}));
    EXPECT_TRUE(said.starts_with("cosim: " + file + ":1:")) << number << ": " << said;
  }
  const std::filesystem::path bad = test::project_root() / "tests/toolpaths/bad";
  const auto error = [&](const char* name, const std::string& what) {
    const std::string file = (bad / name).string();
    expect_refused({"path", file, "--steps-per-mm", "10"}, file + what);
  };
  error("missing_radius.ngc", ":3:4: G2 needs a radius: I, J or R");
  error("work_offset.ngc", ":3:3: G55 is not supported: only the coordinate system G54 is drawn");
  error("end_off_circle.ngc",
        ":3:4: the arc's end is 1 mm off its circle; the tolerance is 0.01 mm");
}

}  // namespace
}  // namespace cosim::cli
