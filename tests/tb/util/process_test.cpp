// No program outlives the one that runs it, nor does what it starts outlive it.
#include "tb/util/process.h"

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

// A process that starts another and leaves one to itself.
const char* const kFamily =
    "touch $TMPDIR/left; echo $TMPDIR > \"$1/folder\"\n"
    "sh -c 'sleep 100000 & echo $! > \"$1/deep\"; wait' sh \"$1\" &\n"
    "(sleep 100000 & echo $! > \"$1/orphan\")\n"
    "until [ -s \"$1/deep\" ]; do sleep 0.01; done\n";

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
  Scratch folder_;
};

TEST_F(Family, EndsWithAProgramThatIsInterrupted) {
  end_by(SIGTERM, [&] { run_program(command("touch \"$1/ready\"; wait")); });
  wait_for([&] { return is_gone("deep") && is_gone("orphan"); });  // else ctest ends it
  EXPECT_FALSE(fs::exists(text("folder")));
  EXPECT_FALSE(fs::exists(text("own")));
  EXPECT_TRUE(fs::exists(folder_.path())) << "this is another process's";
}

// The first process goes with a program that is killed, and one folder is left of it.
TEST_F(Family, LosesItsFirstProcessWithAProgramThatIsKilled) {
  end_by(SIGKILL,
         [&] { run_program(command("echo $$ > \"$1/first\"; touch \"$1/ready\"; wait")); });
  wait_for([&] { return is_gone("first"); });
  for (const char* name : {"deep", "orphan"}) kill(std::stoi(text(name)), SIGKILL);
  EXPECT_EQ(fs::path(text("own")).parent_path(), fs::path(text("folder")).parent_path());
  fs::remove_all(fs::path(text("own")).parent_path());
}

TEST_F(Family, EndsWithItsFirstProcess) {
  const Ended ended = run_program(command("exit 3"));
  EXPECT_EQ(ended.status, 3);
  // They have been killed; it takes them a moment to end.
  wait_for([&] { return is_gone("deep") && is_gone("orphan"); });
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

TEST(RunProgram, GivesItsFolderAndVariablesToTheOther) {
  setenv("COSIM_GOES", "away", 1);
  setenv("COSIM_OTHER", "old", 1);
  const Ended ended =
      run_program({"env", "-u", "COSIM_GOES", "-C", "/usr", "COSIM_OTHER=a=b", "sh", "-c",
                   "pwd; echo \"${COSIM_GOES-none} $COSIM_OTHER $1\"", "sh", "NAME=VALUE"});
  EXPECT_EQ(ended.text, "/usr\nnone a=b NAME=VALUE\n");
  EXPECT_NE(run_program({"env", "-C", "/no/such/folder", "true"}).status, 0);
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
