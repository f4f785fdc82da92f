// --wave, the folder of a failure, and replay, as a person meets them.
// Needs: linear, circular, toolpath
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/cli/program.h"
#include "tests/support/vcd.h"

namespace cosim::cli {
namespace {

using Wave = InAFolder;
using FailureFolder = InAFolder;

// The line behind `head`, which stands in the text once.
std::string behind(const std::string& text, const std::string& head) {
  for (const std::string& line : lines(text)) {
    if (line.starts_with(head)) return line.substr(head.size());
  }
  return "";
}

TEST_F(Wave, OfALineShowsItsWordsAndPath) {
  ends(0, cosim({"line", "--major", "27", "--minor", "9", "--code", "01010", "--m", "5", "--n", "2",
                 "--wave", folder.path("x.fst")}));
  for (const char* name : {"x.fst", "x.gtkw", "x.phase.txt", "x.step.txt"}) {
    EXPECT_TRUE(folder.holds(name)) << name;
  }
  if (!test::can_read_waves()) GTEST_SKIP() << "there is no fst2vcd";
  const test::Vcd wave(folder.path("x.fst"));
  // Table 3 of the source: the words of the minor axis, the first strobe on clock 4.
  const std::vector<std::string> words{"01000101", "01000100", "01000101", "01000000"};
  for (std::size_t i = 0; i < words.size(); ++i) {
    EXPECT_EQ(wave.at("cosim.actual.minor", 10 * (4 + i)), words[i]);
    EXPECT_EQ(wave.at("cosim.expected.minor", 10 * (4 + i)), words[i]);
    EXPECT_EQ(wave.at("linear.minor", 10 * (4 + i)), words[i]);
  }
  const auto number = [&](const char* signal) {
    return std::stoll(wave.at(signal, wave.end()).value_or("-1"), nullptr, 2);
  };
  EXPECT_EQ(number("cosim.path.x"), 27);
  EXPECT_EQ(number("cosim.path.y"), 9);
  EXPECT_EQ(wave.at("cosim.mismatch.any", wave.end()), "0");
}

TEST_F(Wave, OfAnArcEndsAtTheTop) {
  ASSERT_EQ(cosim({"arc", "--radius", "12", "--wave", folder.path("x.fst")}).status, 0);
  if (!test::can_read_waves()) GTEST_SKIP() << "there is no fst2vcd";
  const test::Vcd wave(folder.path("x.fst"));
  EXPECT_EQ(std::stoll(*wave.at("cosim.path.x", wave.end()), nullptr, 2), 0);
  EXPECT_EQ(std::stoll(*wave.at("cosim.path.y", wave.end()), nullptr, 2), 12);
  EXPECT_EQ(std::stoll(*wave.at("cosim.path.x", 10), nullptr, 2), 12);
}

TEST_F(Wave, OfAPathIsOneAMachine) {
  const std::string program = folder.write("p.ngc", "G21 G90 G1 X1 Y0.5 F1\nG2 X2 Y-0.5 I0 J-1\n");
  ends(0, cosim({"path", program, "--steps-per-mm", "20", "--wave", folder.path("x.fst")}));
  EXPECT_TRUE(folder.holds("x.linear.fst"));
  EXPECT_TRUE(folder.holds("x.circular.fst"));
}

TEST_F(Wave, ThatCannotBeDrawnIsSaidFirst) {
  const auto with = [](const std::string& file) {
    return cosim({"arc", "--radius", "5", "--wave", file});
  };
  EXPECT_EQ(refusal(with("")), "cosim: --wave: names no file\n");
  EXPECT_EQ(refusal(with("x.vcd")), "cosim: --wave: x.vcd does not end in .fst\n");
  EXPECT_EQ(refusal(with(".fst")), "cosim: --wave: '.fst' has no name before its .fst\n");
  EXPECT_EQ(refusal(with("/dev/null/x.fst")),
            "cosim: /dev/null/x.fst: cannot write: Not a directory\n");
  EXPECT_EQ(refusal(with(folder.path("none/x.fst"))),
            "cosim: " + folder.path("none/x.fst") + ": cannot write: No such file or directory\n");
}

TEST_F(FailureFolder, OfALineHasAllThatIsNeeded) {
  const std::string failures = folder.path("failures");
  const Ended e =
      ends(1, faulty({"line", "--major", "3000", "--minor", "700", "--failures", failures}));
  const fs::path kept = behind(e.out, "kept in: ");
  ASSERT_TRUE(fs::is_directory(kept)) << e.out;
  EXPECT_EQ(kept.parent_path(), failures);
  for (const char* name : {"report.txt", "report.json", "stimulus.stim", "wave.fst", "wave.gtkw",
                           "smallest.stim", "smallest.fst", "smallest.gtkw"}) {
    EXPECT_TRUE(fs::exists(kept / name)) << name;
  }
  // Nothing else is left, no draft either.
  EXPECT_EQ(std::distance(fs::directory_iterator(failures), fs::directory_iterator()), 1);
  // The command line that is printed can be copied.
  const std::string replay = behind(e.out, "replay: ");
  EXPECT_TRUE(replay.ends_with(" replay " + kept.string())) << replay;
  EXPECT_EQ(WEXITSTATUS(std::system((replay + " > " + folder.path("said")).c_str())), 1) << replay;
}

TEST_F(FailureFolder, IsReplayedToTheSameDifference) {
  const Ended e =
      faulty({"line", "--major", "3000", "--minor", "700", "--failures", folder.path("failures")});
  const std::string first = behind(e.out, "first difference: ");
  ASSERT_NE(first, "");
  const std::string kept = behind(e.out, "kept in: ");
  const Ended again = ends(1, faulty({"replay", kept, "--wave", folder.path("again.fst")}));
  EXPECT_EQ(behind(again.out, "first difference: "), first);
  EXPECT_TRUE(folder.holds("again.fst"));
  EXPECT_FALSE(has(again.out, "kept in"));
  // The machine without the fault has no difference there.
  ends(0, cosim({"replay", kept}));
}

TEST_F(FailureFolder, ThatCannotBeWrittenLeavesTheVerdict) {
  const std::string file = folder.write("taken", "a file");
  const Ended e =
      ends(1, faulty({"line", "--major", "3000", "--minor", "700", "--failures", file}));
  EXPECT_TRUE(has(e.out, "verdict: MISMATCH\n"));
  EXPECT_EQ(lines(e.err).size(), 1U) << e.err;
  EXPECT_TRUE(e.err.starts_with("cosim: the failure is not kept: " + file)) << e.err;
  EXPECT_EQ(folder.text("taken"), "a file");
}

TEST_F(FailureFolder, OfNoRoomLooksLikeNone) {
  const std::string small = folder.path("small");
  fs::create_directory(small);
  if (geteuid() != 0 ||
      std::system(("mount -t tmpfs -o size=8k tmpfs '" + small + "' 2> /dev/null").c_str()) != 0) {
    GTEST_SKIP() << "not here: a full disk cannot be made here";
  }
  const Ended e = faulty({"line", "--major", "3000", "--minor", "700", "--failures", small});
  const auto left = std::distance(fs::directory_iterator(small), fs::directory_iterator());
  EXPECT_EQ(std::system(("umount '" + small + "'").c_str()), 0);
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(e.err.starts_with("cosim: the failure is not kept: ")) << e.err;
  EXPECT_EQ(left, 0);
}

TEST(Replay, RefusesWhatIsNoStimulus) {
  const Folder folder;
  const auto of = [](const Arguments& more) { return refusal(cosim(joined({"replay"}, more))); };
  EXPECT_EQ(of({""}), "cosim: FILE: names no file\n");
  EXPECT_EQ(of({folder.path("none.stim")}),
            "cosim: " + folder.path("none.stim") + ": no such file\n");
  const std::string text = folder.write("x.stim", "G1 X5\n");
  EXPECT_EQ(of({text}), "cosim: " + text + ":1: is not 'cosim stimulus 1'\n");
  const std::string other = folder.write("y.stim", "cosim stimulus 1\nmachine linear M=9 N=2\n");
  EXPECT_EQ(of({other}),
            "cosim: " + other + ":2: no machine 'linear M=9 N=2' is built; see cosim list\n");
  const std::string half = folder.write(
      "z.stim",
      "cosim stimulus 1\nmachine circular W=4\nclock rst load f ct7 ct8 sector2 start stop\n");
  EXPECT_EQ(of({half}), "cosim: " + half + ":3: the file ends before 'end': it is not complete\n");
  fs::create_directory(folder.path("empty"));
  EXPECT_TRUE(has(of({folder.path("empty")}), "empty/stimulus.stim: "));
  EXPECT_EQ(of({text, "--wave", text}).find("cosim: "), 0U);
}

}  // namespace
}  // namespace cosim::cli
