// cosim prove from end to end: what it prints and leaves where RTL and model are the same, and
// where they are not.
// Needs: linear, circular
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tests/cli/program.h"
#include "tests/support/root.h"
#include "tests/support/stand_ins.h"

namespace cosim::cli {
namespace {

const std::string kRtl = (test::project_root() / "rtl").string();
// Channels 1 and 3 are each other's.
const std::string kFault = COSIM_VARIANTS "/circular_faults_variants_swapped";

class Prove : public InAFolder {
 protected:
  void SetUp() override {
    for (const char* program : {"yosys -V", "z3 --version"}) {
      const std::string silent = std::string(program) + " > /dev/null 2>&1";
      if (std::system(silent.c_str()) != 0) GTEST_SKIP() << "needs yosys and z3";
    }
  }
};

bool says(const Ended& ended, const std::string& pattern) { return Pattern(pattern).in(ended.out); }

// What the engines are given can be read, and given to one by hand.
TEST_F(Prove, AMachine) {
  const std::string asked = folder.path("asked");
  const Ended ended = ends(0, cosim({"prove", "circular", "W=4", "--rtl", kRtl, "--keep", asked}));
  EXPECT_TRUE(
      says(ended, "\ncircular W=4 +base case: a reset makes them the same +[0-9. ]+ +proved\n"));
  EXPECT_TRUE(says(ended, "\n3 of 3 claims proved, by cec and cadical, in [0-9.]+ s\n$"))
      << ended.out;
  std::map<std::string, int> answers;
  for (const auto& file : std::filesystem::directory_iterator(asked)) {
    const auto abc = cosim::run_program(
        {"yosys-abc", "-q", "read_aiger " + file.path().string() + "; strash; dsat"});
    ++answers[abc.text.substr(0, abc.text.find(' '))];
  }
  EXPECT_EQ(answers["UNSATISFIABLE"], 2);  // the base case and the step
  EXPECT_EQ(answers["SATISFIABLE"], 33);   // the cases
}

// PATH has an empty folder.
TEST(ProveWithoutEngines, SaysSoInALine) {
  const Folder folder;
  const test::WithPath none(folder.path(""));
  EXPECT_EQ(refusal(cosim({"prove", "circular"})),
            "cosim: prove: needs yosys-abc, which is not installed (apt-get install yosys)\n");
  EXPECT_EQ(refusal(cosim({"prove", "--theorems"})),
            "cosim: prove: needs z3, which is not installed (apt-get install z3)\n");
}

TEST_F(Prove, TheTheoremsOfADesign) {
  const Ended ended = ends(0, cosim({"prove", "--theorems", "circular"}));
  const Pattern verdict("\n([0-9]+) of ([0-9]+) theorems proved\n$");
  const auto counts = verdict.all(ended.out);
  ASSERT_EQ(counts.size(), 1U) << ended.out;
  EXPECT_EQ(counts[0][1], counts[0][2]);
  EXPECT_FALSE(says(ended, "linear"));
}

// What refutes a claim is asked from reset: on benches of that RTL the stimulus is a failure as any
// other, and replays.
TEST_F(Prove, KeepsACounterexampleAsAFailure) {
  setenv("COSIM_VARIANT", "circular/faults/variants_swapped", 1);
  const std::string failures = folder.path("failures");
  const Ended ended =
      ends(1, variant({"prove", "circular", "W=4", "--rtl", kFault, "--failures", failures}));
  EXPECT_TRUE(says(ended, "REFUTED from reset: clock [0-9]+, by ")) << ended.out;
  EXPECT_TRUE(says(ended, "\nfirst difference: clock [0-9]+, ")) << ended.out;
  const auto kept = Pattern("\nkept in: (.*)\n").all(ended.out);
  ASSERT_EQ(kept.size(), 1U) << ended.out;
  const std::string stimulus = kept[0][1] + "/stimulus.stim";
  EXPECT_TRUE(std::filesystem::exists(stimulus));
  std::ifstream text(stimulus);
  EXPECT_FALSE(has(std::string(std::istreambuf_iterator<char>(text), {}), "\nstate "));
  EXPECT_EQ(variant({"replay", stimulus, "--failures", failures}).status, 1);
  EXPECT_EQ(cosim({"replay", stimulus, "--failures", failures}).status, 0);
  unsetenv("COSIM_VARIANT");
}

// A program that was built from other RTL cannot replay it: it says what differs, and keeps it.
TEST_F(Prove, ShowsACounterexampleOfOtherRtl) {
  const std::string failures = folder.path("failures");
  const Ended ended =
      ends(1, cosim({"prove", "circular", "W=4", "--rtl", kFault, "--failures", failures}));
  EXPECT_TRUE(says(ended, "\nfrom reset, on clock [0-9]+: (register|output) ")) << ended.out;
  EXPECT_FALSE(says(ended, "\n3 of 3"));
  const auto kept = Pattern("\nthe gates. As a stimulus: (.*)\n").all(ended.out);
  ASSERT_EQ(kept.size(), 1U) << ended.out;
  EXPECT_EQ(cosim({"replay", kept[0][1], "--failures", failures}).status, 0);
}

// RTL that yosys 0.23 reads otherwise than it is written, an empty text in a concatenation, is seen
// in simulation; nothing is said of it, right or wrong.
TEST_F(Prove, SaysNothingOfRtlThatIsMisread) {
  std::filesystem::copy(kRtl + "/circular", folder.path("circular"));
  const std::string file = folder.path("circular/circular.v");
  std::string text = read_file(file);
  const std::string good = "assign running = t4_q;";
  const std::size_t at = text.find(good);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, good.size(),
               "assign running = t4_q & ({1'b1, \"\", 1'b1} == 10'b10_0000_0001);");
  folder.write("circular/circular.v", text);
  const auto prove = [&] { return cosim({"prove", "circular", "W=4", "--rtl", folder.path("")}); };
  for (const char* time : {"first", "from what is kept of it"}) {
    SCOPED_TRACE(time);
    const Ended ended = prove();
    if (ended.status == 0) GTEST_SKIP() << "not here: this yosys reads it as it is written";
    expect_has(refusal(ended), {"cosim: circular W=4: the RTL is misread: output running is 1 "
                                "on clock ",
                                " in Icarus Verilog, and 0 on the netlist that yosys reads\n"});
  }
}

// One line tells on a terminal which row comes next, and is gone in the end.
TEST_F(Prove, SaysOnATerminalWhatItWaitsFor) {
  if (!has_terminals()) GTEST_SKIP() << "no pseudo-terminal can be had here";
  const Ended ended = cosim_on_terminal(
      {"prove", "circular", "W=4", "--rtl", kFault, "--failures", folder.path("failures")}, 200);
  for (const char* line : {"\r[0-9]+ s: reading the RTL of 1 machine",
                           "\r[0-9]+ s: 1 of 3 claims decided; next: circular W=4, ",
                           "\r[0-9]+ s: asked from reset, at most 300 s: circular W=4, inductive",
                           "\\[K +inductive step: [^\n]*REFUTED from reset"}) {
    EXPECT_TRUE(says(ended, line)) << line << "\n" << ended.out;
  }
}

// The shipped RTL in one file, with a port that chooses among three machines in its place: one that
// says it runs when it does not, one that is the same, and one with registers on the clock's other
// edge.
std::string with_mutants(const Folder& folder) {
  std::string all;
  for (const auto& file : std::filesystem::directory_iterator(kRtl + "/circular")) {
    std::ifstream text(file.path());
    all.append(std::istreambuf_iterator<char>(text), {});
  }
  const auto replace = [&](const std::string& old, const std::string& by) {
    const std::size_t at = all.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    if (at != std::string::npos) all.replace(at, old.size(), by);
  };
  const std::size_t top = all.find("module circular #(");
  EXPECT_NE(top, std::string::npos);
  const std::string others = all.substr(0, top);
  all.erase(0, top);
  replace("W = 16", "W = 4");
  replace("input  wire         clk,", "input wire [15:0] mutsel, input wire clk,");
  replace("assign running = t4_q;",
          "assign running = mutsel == 1 ? ~t4_q : mutsel == 2 ? ~~t4_q : t4_q;");
  replace(".clk(clk)", ".clk(mutsel == 3 ? ~clk : clk)");
  return folder.write("mutants.v", others + all);
}

TEST_F(Prove, RefutesMutantsOrProvesThemTheSame) {
  const std::string file = with_mutants(folder);
  const Arguments command{"prove", "circular", "W=4", "--mutants", file};
  const auto with = [&](const Arguments& more) { return cosim(joined(command, more)); };
  const std::string same = " proved to be the same, 0 undecided\n";
  EXPECT_EQ(with({"--count", "2"}).out, "circular W=4: 2 mutants, 1 refuted, 1" + same);
  // The state and the inputs that tell it apart are those of the model.
  const Ended apart = with({"--mutant", "1"});
  EXPECT_TRUE(says(apart,
                   "1 refuted.*\nfrom this state, under these inputs:\n"
                   "  state  t4 +[01]\n"))
      << apart.out;
  EXPECT_TRUE(says(apart, "\n  out    running +[01]   expected\n +[01]   actual\n")) << apart.out;
  EXPECT_EQ(with({"--mutant", "3"}).out, "circular W=4: 1 mutant, 1 refuted, 0" + same);
  EXPECT_EQ(with({"--mutant", "2"}).out, "circular W=4: 1 mutant, 0 refuted, 1" + same);
  EXPECT_EQ(with({"--mutant", "2", "--count", "1"}).err,
            "cosim: --mutant: is one, with no --count\n");
  // Those that are planted: not one is left undecided.
  const Ended planted = ends(0, cosim({"prove", "circular", "W=4", "--mutants", "10"}));
  EXPECT_TRUE(says(planted,
                   "circular W=4: 10 mutants, [0-9]+ refuted, [0-9]+ proved to be the "
                   "same, 0 undecided\n$"))
      << planted.out;
  EXPECT_EQ(cosim({"prove", "circular", "W=4", "--mutants", "10", "--count", "1"}).err,
            "cosim: --mutants: is a number, with no --mutant and --count\n");
  EXPECT_EQ(cosim({"prove", "circular", "--mutants", file}).err,
            "cosim: --mutants: needs one machine\n");
  EXPECT_EQ(cosim({"prove", "circular", "W=4", "--mutants", folder.path("none")}).err,
            "cosim: " + folder.path("none") + ": no such file\n");
}

}  // namespace
}  // namespace cosim::cli
