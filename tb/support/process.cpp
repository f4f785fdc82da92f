#include "tb/support/process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "model/core/input_error.h"
#include "tb/support/words.h"

namespace cosim {
namespace {

using Clock = std::chrono::steady_clock;

// Seconds that may go by for each one of processor time.
constexpr int kPatience = 20;
// How soon a signal to this program is heeded, which may come to any of its threads.
constexpr int kMilliseconds = 50;

// What runs below a program of several threads: nothing here may take memory.
struct Start {
  char* const* argv;
  char* const* environment;
  int out, limit;
  int held;  // keeps the temporary files
  pid_t parent;
  sigset_t signals;  // as they were blocked before
};

[[noreturn]] void become(const Start& start, pid_t guard) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != guard) _exit(127);
  rlimit now{};
  if (start.limit > 0 && getrlimit(RLIMIT_CPU, &now) == 0) {
    // Where both are the same it is killed, and cannot make anything else of it as of SIGXCPU.
    const rlim_t seconds = std::min(static_cast<rlim_t>(start.limit), now.rlim_max);
    const rlimit wanted{seconds, seconds};
    setrlimit(RLIMIT_CPU, &wanted);
  }
  sigprocmask(SIG_SETMASK, &start.signals, nullptr);
  execvpe(start.argv[0], start.argv, start.environment);
  _exit(127);
}

// Kills the children of this process, and theirs, which become its own as their parents end.
void end_children() {
  char list[4096];
  do {
    const int file = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
    const ssize_t size = file < 0 ? 0 : ::read(file, list, sizeof list);
    close(file);
    pid_t one = 0;
    for (ssize_t i = 0; i < size; ++i) {
      if (list[i] >= '0' && list[i] <= '9') {
        one = 10 * one + (list[i] - '0');
      } else {
        // The last number may be cut off: it comes again.
        if (one > 1) kill(one, SIGKILL);
        one = 0;
      }
    }
  } while (waitpid(-1, nullptr, 0) > 0 || errno == EINTR);
}

// Stands between this program and the other one: adopts what that leaves, and ends it all with
// either of them, however they end. Gives the other one's status as its own.
[[noreturn]] void guard(const Start& start) {
  setpgid(0, 0);  // what a terminal sends to this program is handed on by it
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  std::signal(SIGCHLD, SIG_DFL);
  dup2(open("/dev/null", O_RDWR), STDIN_FILENO);
  dup2(start.out, STDOUT_FILENO);
  dup2(start.out, STDERR_FILENO);
  // Nobody is to wait for the end of a file, or for a lock, because of it; but temporary files stay
  // until what uses them is gone.
  constexpr int held = STDERR_FILENO + 1;
  dup2(start.held, held);
  fcntl(held, F_SETFD, FD_CLOEXEC);
  close_range(held + 1, ~0U, 0);
  const pid_t self = getpid();
  const pid_t child = fork();
  if (child == 0) become(start, self);
  dup2(STDIN_FILENO, STDOUT_FILENO);
  dup2(STDIN_FILENO, STDERR_FILENO);

  sigset_t awaited;
  sigemptyset(&awaited);
  sigaddset(&awaited, SIGCHLD);
  sigaddset(&awaited, SIGTERM);
  int status = 0;
  bool ended = child < 0;
  while (!ended && getppid() == start.parent) {
    if (sigwaitinfo(&awaited, nullptr) == SIGTERM) break;
    for (pid_t one = 0; !ended && (one = waitpid(-1, &status, WNOHANG)) > 0;) ended = one == child;
  }
  if (!ended) {
    kill(child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  }
  end_children();
  _exit(child < 0 ? 127 : WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> list;
  for (const std::string& w : words) list.push_back(const_cast<char*>(w.c_str()));
  list.push_back(nullptr);
  return list;
}

// Solvers and synthesizers take memory and give it back all the time: in a heap that grows by much
// and is never cut, of large pages, a proof takes three fifths of the time. Other libraries than
// glibc do not read this.
constexpr const char* large_heap =
    "glibc.malloc.top_pad=67108864:glibc.malloc.trim_threshold=268435456:"
    "glibc.malloc.mmap_threshold=33554432:glibc.malloc.hugetlb=1";

std::vector<std::string> environment_with(const std::string& folder) {
  std::vector<std::string> list;
  for (char** one = environ; *one != nullptr; ++one) {
    if (std::strncmp(*one, "TMPDIR=", 7) != 0) list.emplace_back(*one);
  }
  list.push_back("TMPDIR=" + folder);
  if (getenv("GLIBC_TUNABLES") == nullptr) {
    list.push_back(fmt::format("GLIBC_TUNABLES={}", large_heap));
  }
  return list;
}

pid_t begin(const std::vector<std::string>& words, const Scratch& scratch, int out, int limit) {
  const std::vector<std::string> environment = environment_with(scratch.path());
  const std::vector<char*> argv = pointers(words), variables = pointers(environment);
  Start start{argv.data(), variables.data(), out, limit, scratch.held(), getpid(), {}};
  // None may come to the guard before it waits for them.
  sigset_t every;
  sigfillset(&every);
  pthread_sigmask(SIG_SETMASK, &every, &start.signals);
  const pid_t child = fork();
  if (child == 0) guard(start);
  const int error = errno;
  pthread_sigmask(SIG_SETMASK, &start.signals, nullptr);
  errno = error;
  return child;
}

// Takes down what a program prints, to its end; false where it is to be ended before that.
bool read_all(int from, std::string& text, Clock::time_point patience,
              const std::atomic<bool>* no_more, bool heeds) {
  std::string part(1 << 16, '\0');
  pollfd waiting{from, POLLIN, 0};
  while ((!heeds || InterruptGuard::signal() == 0) && Clock::now() < patience &&
         (no_more == nullptr || !*no_more)) {
    if (poll(&waiting, 1, kMilliseconds) <= 0) continue;
    const ssize_t n = ::read(from, part.data(), part.size());
    if (n == 0 || (n < 0 && errno != EINTR)) return true;
    if (n > 0) text.append(part, 0, static_cast<std::size_t>(n));
  }
  return false;
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

// `heeds`: the signals that interrupt this program.
Ended run(const std::vector<std::string>& words, int limit, Clock::time_point until,
          const std::atomic<bool>* no_more, bool heeds) {
  const InterruptGuard interrupts;
  const Scratch scratch;
  int ends[2] = {-1, -1};
  const pid_t child = pipe2(ends, O_CLOEXEC) == 0 ? begin(words, scratch, ends[1], limit) : -1;
  if (child < 0) throw InputError(words.front() + ": cannot be run: " + std::strerror(errno));
  close(ends[1]);

  Ended ended;
  const bool to_its_end = read_all(ends[0], ended.text, until, no_more, heeds);
  if (!to_its_end) kill(child, SIGTERM);
  close(ends[0]);
  int status = 0;
  rusage used{};
  while (wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  if (heeds) InterruptGuard::check();
  // A tool that finds none blames what it was given, or nothing.
  require_room(scratch.path());
  ended.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  ended.seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  // The limit is kept in ticks of the clock, and may come a little early.
  const bool out_of_time = ended.status == 128 + SIGKILL && ended.seconds > 0.5 * limit;
  ended.timed_out = !to_its_end || (limit > 0 && out_of_time);
  return ended;
}

}  // namespace

Ended run_program(const std::vector<std::string>& words, int limit,
                  const std::atomic<bool>* no_more) {
  const InterruptGuard interrupts;
  InterruptGuard::check();
  const auto patience = limit == 0 ? Clock::time_point::max()
                                   : Clock::now() + std::chrono::seconds(1LL * kPatience * limit);
  return run(words, limit, patience, no_more, true);
}

Ended run_until(const std::vector<std::string>& words, Clock::time_point until,
                const std::atomic<bool>* no_more) {
  const InterruptGuard interrupts;
  InterruptGuard::check();
  return run(words, 0, until, no_more, true);
}

Ended run_all_the_same(const std::vector<std::string>& words) {
  alarm(0);
  Ended ended;
  try {
    ended = run(words, 0, Clock::time_point::max(), nullptr, false);
  } catch (const InputError& error) {
    ended.status = 127;
    ended.text = error.what();
  }
  if (InterruptGuard::signal() != 0) alarm(InterruptGuard::seconds);
  return ended;
}

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access(((folder.empty() ? "." : folder) + '/' + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

}  // namespace cosim
