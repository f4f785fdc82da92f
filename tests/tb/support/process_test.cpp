// No program outlives the one that runs it, nor does anything that it starts or leaves.
#include "tb/support/process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

namespace cosim {
namespace {

namespace fs = std::filesystem;

// A process that starts others as ninja does, each in a group of its own, and leaves one to itself.
const char* const kFamily =
    "touch $TMPDIR/left; echo $TMPDIR > \"$1/folder\"; set -m\n"
    "sh -c 'sleep 100000 & echo $! > \"$1/deep\"; wait' sh \"$1\" &\n"
    "(sleep 100000 & echo $! > \"$1/orphan\")\n"
    "until [ -s \"$1/deep\" ]; do sleep 0.01; done; touch \"$1/ready\"\n";

class Family : public testing::Test {
 protected:
  std::string text(const char* name) const {
    std::string line;
    std::ifstream file(folder_.path() / name);
    std::getline(file, line);
    return line;
  }
  std::vector<std::string> command(const std::string& then) const {
    return {"bash", "-c", kFamily + then, "bash", folder_.path()};
  }
  static void wait_for(const std::function<bool()>& event) {
    while (!event()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  // A zombie that nobody has waited for yet is gone too.
  bool is_gone(const char* name) const {
    std::ifstream file("/proc/" + text(name) + "/stat");
    std::string line;
    return !std::getline(file, line) || line.find(") Z ") != std::string::npos;
  }
  // A child of this program runs it, with a folder for temporary files, and ends by a signal.
  void end_by(int signal, const std::function<void()>& program) {
    const pid_t child = fork();
    if (child == 0) {
      try {
        const Scratch own;
        std::ofstream(folder_.path() / "own") << own.path().string() << '\n';
        program();
      } catch (...) {
      }
      _exit(0);
    }
    wait_for([&] { return fs::exists(folder_.path() / "ready"); });
    kill(child, signal);
    waitpid(child, nullptr, 0);
  }
  void expect_none_outlives(int signal) {
    end_by(signal, [&] { run_program(command("wait")); });
    // Without the guard these wait for ever; ctest ends them.
    wait_for([&] { return is_gone("deep") && is_gone("orphan"); });
    wait_for([&] { return !fs::exists(text("folder")) && !fs::exists(text("own")); });
    EXPECT_TRUE(fs::exists(folder_.path())) << "this is another process's";
  }

  Scratch folder_;
};

TEST_F(Family, EndsWithAProgramThatIsKilled) { expect_none_outlives(SIGKILL); }
TEST_F(Family, EndsWithAProgramThatIsInterrupted) { expect_none_outlives(SIGTERM); }

// Where it runs no other program either.
TEST_F(Family, LeavesNoFolderOfAProgramThatIsKilled) {
  end_by(SIGKILL, [&] {
    std::ofstream(folder_.path() / "ready") << '\n';
    pause();
  });
  wait_for([&] { return !fs::exists(text("own")); });
}

TEST_F(Family, EndsWithItsFirstProcess) {
  const Ended ended = run_program(command("exit 3"));
  EXPECT_EQ(ended.status, 3);
  EXPECT_TRUE(is_gone("deep"));
  EXPECT_TRUE(is_gone("orphan"));
  EXPECT_FALSE(fs::exists(text("folder")));
}

TEST(RunProgram, GivesTheStatusAndTheTextOfTheOther) {
  const Ended ended = run_program({"sh", "-c", "echo out; echo err >&2; kill -9 $$"});
  EXPECT_EQ(ended.status, 128 + SIGKILL);
  EXPECT_EQ(ended.text, "out\nerr\n");
  EXPECT_EQ(run_program({"no_such_program"}).status, 127);
  EXPECT_FALSE(is_installed("no_such_program"));
  EXPECT_TRUE(is_installed("sh"));
}

// It takes no time of a processor.
TEST(RunUntil, StopsAProgramThatOnlyWaits) {
  const auto soon = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
  EXPECT_TRUE(run_until({"sleep", "1000000"}, soon).timed_out);
  const auto late = std::chrono::steady_clock::now() + std::chrono::hours(24);
  const Ended ended = run_until({"sh", "-c", "exit 4"}, late);
  EXPECT_FALSE(ended.timed_out);
  EXPECT_EQ(ended.status, 4);
}

}  // namespace
}  // namespace cosim
