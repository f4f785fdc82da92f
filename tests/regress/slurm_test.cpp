// What is asked of Slurm, with programs in its place that run every job at once. On a real one:
// scripts/test --slurm.
// Needs: linear
#include <cstdlib>
#include <filesystem>

#include "tb/util/pattern.h"
#include "tests/regress/run.h"

namespace cosim::cli {
namespace {

// Notes its arguments; of an array it runs each task, of a job the job.
constexpr const char* sbatch = R"(#!/bin/sh
echo "sbatch $*" >> "$TRIAL/asked"
PATH=$TRIAL/node:$PATH
case $* in *partition=none*) echo "sbatch: error: no such partition" && exit 1 ;; esac
last=-1
for word; do
  case $word in --array=0-*) last=${word#--array=0-} ;; esac
  script=$word
done
i=0
while [ "$i" -le "$last" ]; do
  SLURM_JOB_ID=5$i SLURM_ARRAY_TASK_ID=$i SLURMD_NODENAME=n$i sh "$script"
  i=$((i + 1))
done
[ "$last" != -1 ] || sh "$script" > "$TRIAL/merged"
echo "$(grep -c . "$TRIAL/asked");trial"
)";

class Cluster : public Regression {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder_.path("bin"));
    program("sbatch", sbatch);
    program("squeue",
            "#!/bin/sh\necho \"slurm_load_jobs error: Invalid job id specified\"\nexit 1\n");
    program("scancel", "#!/bin/sh\necho \"scancel $*\" >> \"$TRIAL/asked\"\n");
    setenv("TRIAL", folder_.path("").c_str(), 1);
    setenv("PATH", (folder_.path("bin") + ":" + path_).c_str(), 1);
    plan(R"({"name": "large", "sweep": "linear M=5 N=2", "random": 30, "memory": 3000},
            {"name": "small", "sweep": "linear M=5 N=2", "hostile": 30000, "minutes": 8})");
  }
  void TearDown() override {
    setenv("PATH", path_.c_str(), 1);
    unsetenv("SBATCH_TIMELIMIT");
  }
  void program(const std::string& name, const std::string& text) const {
    std::filesystem::permissions(folder_.write("bin/" + name, text),
                                 std::filesystem::perms::owner_all);
  }
  std::vector<std::string> asked() const { return lines(folder_.text("asked")); }

 private:
  std::string path_ = std::getenv("PATH");
};

bool has_word(const std::string& line, const std::string& word) {
  return (line + ' ').find(' ' + word + ' ') != std::string::npos;
}

TEST_F(Cluster, RunsArraysAndAJobBehindThem) {
  ends(0, cosim(fresh("run",
                      {"--shards", "9", "--slurm", "--sbatch", "account=some partition=main"})));
  const auto calls = asked();
  ASSERT_EQ(calls.size(), 3U);
  EXPECT_TRUE(has_word(calls[0], "--array=0-7")) << calls[0];
  EXPECT_FALSE(has(calls[0], "--mem"));
  EXPECT_TRUE(has_word(calls[1], "--array=0-0")) << calls[1];
  EXPECT_TRUE(has_word(calls[1], "--mem=3000M"));
  EXPECT_TRUE(has_word(calls[2], "--dependency=afterany:1:2")) << calls[2];
  for (const char* word : {"--requeue", "--signal=B:TERM@120", "--time=14"}) {
    EXPECT_TRUE(has_word(calls[0], word)) << word << ": " << calls[0];
  }
  for (const std::string& call : calls) {
    EXPECT_TRUE(has_word(call, "--account=some") && has_word(call, "--partition=main")) << call;
  }
  EXPECT_TRUE(has(folder_.text("merged"), "verdict: pass"));
  EXPECT_EQ(times("run")["hosts"]["n3"], 1);

  ASSERT_EQ(cosim(fresh("here", {"--shards", "1"})).status, 0);
  EXPECT_EQ(report("run"), report("here"));
}

// Nodes have no yosys, and perhaps vectors less wide.
TEST_F(Cluster, HasLanesMadeForItsNodes) {
  const std::string sweeps = R"({"name": "pins", "sweep": "linear M=5 N=2", "hostile": 30000$},
                               {"name": "jobs", "sweep": "linear M=5 N=2", "random": 3000$})";
  const auto with = [&](const std::string& lanes) {
    return Pattern(R"(\$)").replaced(sweeps, lanes);
  };
  plan(with(""));
  ASSERT_EQ(cosim(fresh("alone", {"--shards", "1"})).status, 0);
  plan(with(R"(, "lanes": true)"));
  std::filesystem::create_directory(folder_.path("node"));
  program("../node/yosys", "#!/bin/sh\nexit 127\n");
  ends(0, cosim(fresh("run", {"--shards", "5", "--slurm"})));
  EXPECT_EQ(report("run"), report("alone"));
  EXPECT_TRUE(folder_.holds("run/prepared/0/64.so"));

  // They are what runs: a node that cannot load them says so.
  for (const auto& library : std::filesystem::directory_iterator(folder_.path("run/prepared/0"))) {
    folder_.write("run/prepared/0/" + library.path().filename().string(), "none");
  }
  std::filesystem::remove_all(folder_.path("run/results"));
  std::filesystem::create_directory(folder_.path("run/results"));
  EXPECT_EQ(cosim({"regress", "--resume", folder_.path("run"), "--slurm"}).status, 2);
}

TEST_F(Cluster, IsAskedNothingThatAVariableSays) {
  setenv("SBATCH_TIMELIMIT", "5", 1);
  ASSERT_EQ(cosim(fresh("run", {"--shards", "2", "--slurm"})).status, 0);
  for (const std::string& call : asked()) {
    EXPECT_FALSE(has(call, "--time"));
  }
}

TEST_F(Cluster, ThatRefusesIsALine) {
  EXPECT_EQ(refusal(cosim(fresh("run", {"--slurm", "--sbatch", "partition=none"}))),
            "cosim: sbatch: error: no such partition\n");
  // What was submitted before that is cancelled.
  program("sbatch",
          "#!/bin/sh\n[ -e \"$TRIAL/once\" ] && echo no && exit 1\n"
          "touch \"$TRIAL/once\"\necho 5\n");
  EXPECT_EQ(cosim({"regress", "--resume", folder_.path("run"), "--slurm"}).status, 2);
  EXPECT_EQ(asked().back(), "scancel --quiet 5");
}

// A job that ends without a word leaves its shards missing, for --resume.
TEST_F(Cluster, ThatLosesJobsLeavesThemToBeRunAgain) {
  program("sbatch", "#!/bin/sh\necho 5\n");
  const Ended e = cosim(fresh("run", {"--shards", "9", "--slurm"}));
  EXPECT_TRUE(has(refusal(e), "shards 0-8: left no result; see "));
  EXPECT_TRUE(has(e.out, "verdict: UNFINISHED"));
  program("sbatch", sbatch);
  EXPECT_EQ(cosim({"regress", "--resume", folder_.path("run"), "--slurm"}).status, 0);
}

TEST_F(Cluster, HasAtMostAThousandTasksInAnArray) {
  plan(R"({"name": "many", "sweep": "linear M=5 N=2", "hostile": 3000000})");
  program("sbatch", "#!/bin/sh\necho \"sbatch $*\" >> \"$TRIAL/asked\"\necho 5\n");
  EXPECT_EQ(cosim(fresh("run", {"--shards", "2500", "--slurm"})).status, 2);
  EXPECT_TRUE(has_word(asked()[0], "--array=0-999")) << asked()[0];
  const auto lists = lines(folder_.text("run/slurm/1.txt"));
  ASSERT_EQ(lists.size(), 1000U);
  EXPECT_EQ(lists[0], "0-1");
  EXPECT_EQ(lists[1], "2-4");
  EXPECT_EQ(lists[999], "2497-2499");
}

TEST_F(Cluster, HasTasksOnlyInArrays) {
  ASSERT_EQ(cosim(fresh("run", {"--shards", "2", "--slurm"})).status, 0);
  const Ended e = ends(2, cosim({"regress", "--work", folder_.path("run"), "--list", "1.txt"}));
  EXPECT_EQ(e.err, "cosim: --list: only in a task of a job array\n");
}

}  // namespace
}  // namespace cosim::cli
