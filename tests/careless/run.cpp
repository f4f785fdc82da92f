#include "tests/careless/run.h"

#include <fcntl.h>
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

namespace cosim::careless {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

void open_as(int stream, const std::string& path, int how) {
  const int file = open(path.c_str(), how, 0600);
  if (file < 0) _exit(125);
  if (file != stream) {
    dup2(file, stream);
    close(file);
  }
}

void direct(Stream kind, int stream, const std::string& path) {
  switch (kind) {
    case Stream::file:
      return open_as(stream, path, O_WRONLY | O_CREAT | O_TRUNC);
    case Stream::closed:
      close(stream);
      return;
    case Stream::full:
      return open_as(stream, "/dev/full", O_WRONLY);
    case Stream::gone: {
      int ends[2];
      if (pipe(ends) != 0) _exit(125);
      close(ends[0]);
      dup2(ends[1], stream);
      close(ends[1]);
      return;
    }
  }
}

void limit(int what, long most) {
  const rlimit both{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
  setrlimit(what, &both);
}

[[noreturn]] void become(const std::string& program, const Case& one, const Scratch& scratch,
                         const std::string& streams) {
  setpgid(0, 0);
  if (chdir(scratch.work().c_str()) != 0) _exit(125);
  setenv("TMPDIR", (scratch.folder() / "tmp").c_str(), 1);
  setenv("HOME", (scratch.folder() / "home").c_str(), 1);
  unsetenv("COSIM_FAILURES");
  setenv("CCACHE_DISABLE", "1", 1);  // a compiler's cache is its user's, and outlives a kill
  direct(one.out, STDOUT_FILENO, streams + ".out");
  direct(one.err, STDERR_FILENO, streams + ".err");
  if (one.in == Stream::file) {
    open_as(STDIN_FILENO, "/dev/null", O_RDONLY);
  } else {
    close(STDIN_FILENO);
  }
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, one.largest_file != 0 ? one.largest_file : longest_output);
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& a : one.arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
  _exit(126);
}

// Whether the child ended in that time.
bool ends_within(pid_t child, milliseconds time, int& status, rusage& used) {
  const auto end = Clock::now() + time;
  for (auto nap = std::chrono::microseconds(500);; nap = std::min(2 * nap, nap.max())) {
    if (wait4(child, &status, WNOHANG, &used) == child) return true;
    if (Clock::now() >= end) return false;
    std::this_thread::sleep_for(std::min<Clock::duration>(
        {nap, milliseconds(10), std::max<Clock::duration>(end - Clock::now(), milliseconds(0))}));
  }
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
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork");
  if (child == 0) become(program, one, scratch, streams);
  Came came;
  int status = 0;
  rusage used{};
  if (!ends_within(child, milliseconds(one.after), status, used)) {
    came.signalled = true;
    kill(child, one.signal);
    if (!ends_within(child, milliseconds(patience), status, used)) {
      came.hung = true;
      kill(child, SIGKILL);
      wait4(child, &status, 0, &used);
    }
  }
  came.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  came.left = count_left();
  if (came.left != 0) end_left();
  came.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  came.peak = used.ru_maxrss * 1024;
  came.out = end_of(streams + ".out");
  came.err = end_of(streams + ".err");
  return came;
}

}  // namespace cosim::careless
