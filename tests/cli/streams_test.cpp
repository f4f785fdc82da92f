// Files and streams that cannot be written, or are wanted for something else.
// Needs: linear, circular, toolpath
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <future>

#include "tests/cli/program.h"
#include "tests/support/sanitized.h"

namespace cosim::cli {
namespace {

using Streams = InAFolder;
using StandardOutput = InAFolder;

Ended line(const Arguments& more, const Output& output = {}) {
  return cosim(joined({"line", "--major", "27", "--minor", "9"}, more), output);
}

constexpr const char* no_folder = ": cannot write: No such file or directory";

void expect_error(const Ended& ended, const std::string& error) {
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err, "cosim: " + error + "\n");
}

TEST_F(Streams, ThatCannotBeWrittenIsSaid) {
  for (const char* option : {"--csv", "--report"}) {
    expect_error(line({option, folder.path("none/x")}), folder.path("none/x") + no_folder);
    expect_error(line({option, folder.path("")}),
                 folder.path("") + ": cannot write: Is a directory");
    expect_error(line({option, "/dev/full"}), "/dev/full: cannot write: No space left on device");
    expect_error(line({option, std::string(5000, 'x')}),
                 std::string(5000, 'x') + ": cannot write: File name too long");
  }
  expect_error(line({"--csv", "a\nb/c"}), "a?b/c: cannot write: No such file or directory");
}

// Long before the run is over.
TEST_F(Streams, ThatCannotBeWrittenIsSaidFirst) {
  const std::string bad = folder.path("none/x");
  const Ended ended = cosim({"sweep", "linear", "--random", "281474976710656", "--report", bad});
  expect_error(ended, bad + no_folder);
  EXPECT_EQ(ended.out, "");
  // And with nothing lost of the other file.
  folder.write("csv", "kept\n");
  expect_error(line({"--csv", folder.path("csv"), "--report", bad}), bad + no_folder);
  EXPECT_EQ(folder.text("csv"), "kept\n");
}

TEST_F(Streams, WithoutRoomKeepsTheVerdict) {
  const Ended ended = line({"--report", "/dev/full"});
  EXPECT_TRUE(has(ended.out, "verdict: match\n"));
}

TEST_F(Streams, OfBothKindsNeedsTwoFiles) {
  const std::string a = folder.path("a");
  expect_error(line({"--csv", a, "--report", a}), "--report: " + a + " is the file of --csv");
  EXPECT_FALSE(folder.holds("a"));
  const std::string roundabout =
      folder.path("./../" + fs::path(folder.path("")).parent_path().filename().string() + "/a");
  expect_error(line({"--csv", a, "--report", roundabout}),
               "--report: " + roundabout + " is the file of --csv");
  folder.write("a", "kept\n");
  fs::create_hard_link(a, folder.path("hard"));
  fs::create_symlink(a, folder.path("soft"));
  for (const char* link : {"hard", "soft"}) {
    expect_error(line({"--csv", a, "--report", folder.path(link)}),
                 "--report: " + folder.path(link) + " is the file of --csv");
  }
  EXPECT_EQ(folder.text("a"), "kept\n");
  EXPECT_EQ(line({"--csv", "/dev/null", "--report", "/dev/null"}).status, 0);
}

TEST_F(Streams, IsNotWrittenOverTheProgramRead) {
  const std::string program = "G0 X10\n";
  const std::string file = folder.write("p.ngc", program);
  for (const char* option : {"--csv", "--report"}) {
    expect_error(cosim({"path", file, "--steps-per-mm", "10", option, folder.path("./p.ngc")}),
                 std::string(option) + ": " + folder.path("./p.ngc") + " is the file that is read");
    EXPECT_EQ(folder.text("p.ngc"), program);
  }
}

// What lies beside a wave, under names made from its own.
TEST_F(Streams, OfAWaveAreApartFromAllOthers) {
  const std::string wave = folder.path("w.fst");
  for (const char* name : {"w.fst", "w.gtkw", "w.phase.txt", "w.step.txt"}) {
    const std::string file = folder.path(name);
    expect_error(line({"--wave", wave, "--csv", file}),
                 "--wave: " + file + " is the file of --csv");
    expect_error(line({"--wave", wave, "--report", file}),
                 "--wave: " + file + " is the file of --report");
  }
  for (const char* name : {"w.linear.fst", "w.circular.gtkw", "w.linear.step.txt"}) {
    const std::string file = folder.write(name, "G0 X10\n");
    expect_error(cosim({"path", file, "--steps-per-mm", "10", "--wave", wave}),
                 "--wave: " + file + " is the file that is read");
    EXPECT_EQ(folder.text(name), "G0 X10\n");
  }
}

TEST_F(Streams, OfFailuresNeedAFolder) {
  expect_error(line({"--failures", ""}), "--failures: names no folder");
}

TEST_F(Streams, IsNotWrittenOverTheText) {
  for (const std::string& file : {folder.path("text"), std::string("/dev/stdout")}) {
    expect_error(line({"--csv", file}, {folder.path("text")}),
                 "--csv: " + file + " is where standard output goes");
  }
}

TEST_F(Streams, ReplacesWhatStoodThere) {
  folder.write("csv", std::string(100000, 'x'));
  folder.write("report", std::string(100000, 'x'));
  EXPECT_EQ(line({"--csv", folder.path("csv"), "--report", folder.path("report")}).status, 0);
  EXPECT_EQ(lines(folder.text("csv")).size(), 5U);
  EXPECT_FALSE(has(folder.text("report"), "xxx"));
}

// What can be known before the run is checked before: nothing is lost and nothing waited for.
TEST_F(Streams, ThatWouldBeTooLongAreRefusedFirst) {
  const std::string csv = folder.write("csv", "kept\n"), wave = folder.path("w.fst");
  const std::string picture = folder.path("p.svg");
  const std::string program = folder.write("p.ngc", "G1 X4000 Y1 F1\n");
  const auto refused = [&](Arguments command, const std::string& error) {
    command.insert(command.end(), {"--csv", csv});
    const Ended ended = cosim(command);
    EXPECT_EQ(ended.out, "");
    expect_error(ended, error);
    EXPECT_EQ(folder.text("csv"), "kept\n");
    EXPECT_LT(ended.peak, 100'000'000 + test::kept_back);
    EXPECT_FALSE(folder.holds("w.fst") || folder.holds("p.svg"));
  };
  const std::string clocks = " clocks are more than can be drawn, 2000000";
  const std::string steps = "--plot: a path of more than 999999 steps is too long to draw";
  refused({"line", "--major", "4000000000", "--minor", "1", "--wave", wave},
          "--wave: 62500000" + clocks);
  refused({"arc", "--radius", "4294967295", "--wave", wave}, "--wave: 6074000999" + clocks);
  refused({"path", program, "--steps-per-mm", "500000", "--wave", wave},
          "--wave: 31250000" + clocks);
  refused({"line", "--major", "1000000", "--minor", "1", "--plot", picture}, steps);
  refused({"arc", "--radius", "1000000", "--plot", picture}, steps);
  refused({"path", program, "--steps-per-mm", "250", "--plot", picture}, steps);
}

TEST_F(Streams, KeepTheRightsOfWhatTheyReplace) {
  const fs::path csv = folder.write("csv", "secret\n");
  fs::permissions(csv, fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(line({"--csv", csv}).status, 0);
  EXPECT_EQ(fs::status(csv).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(lines(folder.text("csv")).size(), 5U);
}

TEST_F(Streams, GoesIntoAPipe) {
  ASSERT_EQ(mkfifo(folder.path("pipe").c_str(), 0600), 0);
  auto read = std::async(std::launch::async, [&] { return folder.text("pipe"); });
  EXPECT_EQ(line({"--report", folder.path("pipe")}).status, 0);
  EXPECT_EQ(read.get().substr(0, 2), "{\n");
}

TEST_F(StandardOutput, WithoutRoomIsAnError) {
  for (const Arguments& more : {Arguments{}, Arguments{"--table"}}) {
    expect_error(line(more, {"/dev/full"}), "cannot write to standard output");
  }
  expect_error(cosim({"list"}, {"/dev/full"}), "cannot write to standard output");
  expect_error(cosim({"--help"}, {"/dev/full"}), "cannot write to standard output");
  // More than any buffer holds.
  expect_error(cosim({"arc", "--radius", "5000", "--table"}, {"/dev/full"}),
               "cannot write to standard output");
}

// The CSV must not become the standard output that is missing.
TEST_F(StandardOutput, ClosedIsAnError) {
  Output closed;
  closed.closed = true;
  expect_error(line({"--csv", folder.path("csv")}, closed), "cannot write to standard output");
  EXPECT_EQ(lines(folder.text("csv")).size(), 5U) << folder.text("csv");
}

// There is nobody to tell, but the status tells.
TEST(StandardError, ClosedOrFullKeepsTheStatus) {
  for (const Output& nowhere : {Output{"", false, "", true}, Output{"", false, "/dev/full"}}) {
    EXPECT_EQ(cosim({"line", "--major", "5"}, nowhere).status, 2);
    EXPECT_EQ(cosim({"line", "--size"}, nowhere).status, 2);
    EXPECT_EQ(line({}, nowhere).status, 0);
  }
  Output nothing;
  nothing.closed = nothing.err_closed = true;
  EXPECT_EQ(line({}, nothing).status, 2);
}

// A reader that has seen enough ends the program without a word, as it does any other.
TEST_F(StandardOutput, OfAReaderGoneEndsTheProgram) {
  ASSERT_EQ(mkfifo(folder.path("pipe").c_str(), 0600), 0);
  auto read = std::async(std::launch::async, [&] {
    std::ifstream pipe(folder.path("pipe"));
    std::string line;
    std::getline(pipe, line);
    return line;
  });
  const Ended ended = cosim({"arc", "--radius", "100000", "--table"}, {folder.path("pipe")});
  EXPECT_EQ(read.get().substr(0, 14), "circular W=24:");
  EXPECT_EQ(ended.status, 128 + SIGPIPE);
  EXPECT_EQ(ended.err, "");
}

}  // namespace
}  // namespace cosim::cli
