#include "tests/careless/run.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "tests/support/child.h"

namespace cosim::careless {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

void limit(int what, long most) {
  const rlimit both{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
  setrlimit(what, &both);
}

// What the case has of its own: a folder, a home, and no more than so large files.
void prepare(const Case& one, const Scratch& scratch) {
  setpgid(0, 0);
  if (chdir(scratch.work().c_str()) != 0) _exit(125);
  setenv("TMPDIR", (scratch.folder() / "tmp").c_str(), 1);
  setenv("HOME", (scratch.folder() / "home").c_str(), 1);
  unsetenv("COSIM_FAILURES");
  setenv("CCACHE_DISABLE", "1", 1);  // a compiler's cache is its user's, and outlives a kill
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, one.largest_file != 0 ? one.largest_file : longest_output);
}

// Children of a child that is gone have become ours. A killed one takes a moment.
int count_left() {
  for (int i = 0; i < 6000; ++i) {
    const pid_t one = waitpid(-1, nullptr, WNOHANG);
    if (one < 0) return 0;
    if (one == 0) std::this_thread::sleep_for(milliseconds(10));
  }
  return 1;
}

// Of this process all children are the case's: they end by their numbers.
void end_left() {
  std::ifstream list("/proc/self/task/" + std::to_string(getpid()) + "/children");
  for (pid_t one = 0; list >> one;) kill(one, SIGKILL);
  while (waitpid(-1, nullptr, 0) > 0) continue;
}

std::string end_of(const std::string& path) {
  constexpr std::streamoff longest = 1 << 16;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return {};
  file.seekg(std::max<std::streamoff>(0, file.tellg() - longest));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  unlink(path.c_str());
  return text;
}

}  // namespace

void adopt() {
  // As nohup and a shell's background have them the cases would inherit them.
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
  if (prctl(PR_SET_CHILD_SUBREAPER, 1) != 0) throw std::runtime_error("no subreaper");
}

Came run(const std::string& program, const Case& one, const Scratch& scratch) {
  const std::string streams = scratch.folder().string();
  const auto begin = Clock::now();
  test::Child child(program, one.arguments,
                    {one.in, one.out, one.err, streams + ".out", streams + ".err"},
                    [&] { prepare(one, scratch); });
  Came came;
  if (!child.ends_within(milliseconds(one.after))) {
    came.signalled = true;
    child.signal(one.signal);
    if (!child.ends_within(milliseconds(patience))) {
      came.hung = true;
      child.signal(SIGKILL);
    }
  }
  came.status = child.status();
  came.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  came.left = count_left();
  if (came.left != 0) end_left();
  came.peak = child.peak();
  came.out = end_of(streams + ".out");
  came.err = end_of(streams + ".err");
  return came;
}

}  // namespace cosim::careless
