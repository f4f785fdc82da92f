// Ctrl-C in a proof: the program that it waits for is ended, and its folder gone.
// Needs: linear, circular
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "tests/cli/program.h"
#include "tests/support/root.h"
#include "tests/support/stand_ins.h"

namespace cosim::cli {
namespace {

// How many processes have a word in their command line; those that cannot be read have not.
int running(const std::string& word) {
  int found = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream stream(entry.path() / "cmdline");
    std::string line;
    std::getline(stream, line, '\n');  // all of it, and none of a process that has just ended
    found += line.find(word) != std::string::npos ? 1 : 0;
  }
  return found;
}

// In an environment with a folder for temporary files, and programs found before all others.
class InterruptedProof : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    fs::create_directory(folder_.path("tmp"));
    setenv("TMPDIR", folder_.path("tmp").c_str(), 1);
  }
  void TearDown() override { unsetenv("TMPDIR"); }

  // A program that does not end.
  void stand_in(const char* name, const std::string& before = "") {
    bin_.program(name, before + "\nexec tail -f " + waits_);
  }

  Ended expect_ended(const Arguments& arguments) {
    const Ended e = cosim_signalled(arguments, GetParam(), [this] { return running(waits_) > 0; });
    EXPECT_EQ(e.status, 128 + GetParam());
    EXPECT_EQ(e.err, "");
    EXPECT_EQ(running(waits_), 0);
    EXPECT_TRUE(fs::is_empty(folder_.path("tmp")));
    return e;
  }

  Folder folder_;
  const test::StandIns bin_{};
  const std::string waits_ = folder_.write("waits", "");
  const std::string rtl_ = (test::project_root() / "rtl").string();
};

TEST_P(InterruptedProof, EndsYosys) {
  stand_in("yosys");
  expect_ended({"prove", "linear", "--rtl", rtl_});
}

TEST_P(InterruptedProof, EndsTheSolvers) {
  stand_in("z3");
  expect_ended({"prove", "--theorems", "circular"});
}

// The rows of what was decided before it are there.
TEST_P(InterruptedProof, EndsWhatIsAskedFromReset) {
  stand_in("yosys-abc", "case \"$*\" in *asked.aig*) ;; *) PATH=" + bin_.path.before +
                            " exec yosys-abc \"$@\" ;; esac");
  const std::string fault = COSIM_VARIANTS "/circular_faults_variants_swapped";
  const Ended e = expect_ended({"prove", "circular", "W=4", "--rtl", fault});
  EXPECT_TRUE(has(e.out, "circular W=4         base case: "));
  EXPECT_FALSE(has(e.out, "inductive step"));
}

// While it reads, while the engines look, and while a difference is replayed: no folder is kept.
TEST_P(InterruptedProof, EndsAComparison) {
  const auto rtl = [&](const char* name, const std::string& next) {
    return folder_.write(name,
                         "module m(input clk, input [7:0] d, output reg [7:0] q);\n"
                         "always @(posedge clk) q <= " +
                             next + ";\nendmodule\n");
  };
  const Arguments compared{
      "equiv", "--gold",     rtl("gold.v", "d + 1"), "--gate", rtl("gate.v", "d + 2"), "--top",
      "m",     "--failures", folder_.path("kept")};
  for (const char* tool : {"vvp", "yosys-abc", "yosys"}) {
    stand_in(tool);
    expect_ended(compared);
    fs::remove(bin_.folder.path(tool));
    EXPECT_FALSE(folder_.holds("kept")) << tool;
  }
}

// Random stimuli go on beside the engines, and end with them.
TEST_P(InterruptedProof, EndsASearchAtOnce) {
  const auto rtl = [&](const char* name, const std::string& y) {
    return folder_.write(name,
                         "module m(input clk, input rst, output y);\nreg [40:0] c;\n"
                         "always @(posedge clk) if (rst) c <= 0; else c <= c * 5 + 3;\n"
                         "assign y = " +
                             y + ";\nendmodule\n");
  };
  stand_in("yosys-abc", "case \"$*\" in *bmc3*) ;; *) exit 0 ;; esac");
  const auto waits = [this] { return running(waits_) > 0; };
  std::chrono::steady_clock::time_point began;
  const Ended e = cosim_signalled({"equiv", "--gold", rtl("gold.v", "&c"), "--gate",
                                   rtl("gate.v", "0"), "--top", "m", "--netlists"},
                                  GetParam(), [&] {
                                    began = std::chrono::steady_clock::now();
                                    return waits();
                                  });
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(5));
  EXPECT_EQ(e.status, 128 + GetParam());
  EXPECT_EQ(running(waits_), 0);
}

TEST_P(InterruptedProof, EndsGnuplot) {
  stand_in("gnuplot", "[ \"$1\" != --version ] || exit 0");
  expect_ended({"line", "--major", "5", "--minor", "3", "--plot", folder_.path("plot.svg")});
}

INSTANTIATE_TEST_SUITE_P(On, InterruptedProof, testing::Values(SIGHUP, SIGINT, SIGQUIT, SIGTERM),
                         [](const auto& at) {
                           return std::string("SIG") + sigabbrev_np(at.param);
                         });

// What a busy computer, or a harder question, may end with.
TEST(ProofAtItsLimit, SaysWhatToDo) {
  const Folder folder;
  const test::StandIns bin{};
  bin.program("z3", "mkdir " + folder.path("once") +
                        " 2> /dev/null && exec sha256sum /dev/zero\necho unknown");
  const Ended e = cosim({"prove", "--theorems", "circular", "--limit", "1"});
  EXPECT_EQ(e.status, 1) << e.err;
  ASSERT_FALSE(e.out.empty());
  EXPECT_EQ(lines(e.out).back(),
            "an engine was stopped after 1 s of processor time; give it more: --limit 10");
}

}  // namespace
}  // namespace cosim::cli
