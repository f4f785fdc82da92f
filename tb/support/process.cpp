#include "tb/support/process.h"

#include <fcntl.h>
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
#include <system_error>

#include "model/core/input_error.h"

namespace cosim {
namespace {

using Clock = std::chrono::steady_clock;

// Seconds that may go by for each one of processor time.
constexpr int kPatience = 20;
// How soon a signal to this program is heeded, which may come to any of its threads.
constexpr int kMilliseconds = 50;

// In the child of a program with threads: nothing here may take memory.
[[noreturn]] void become(char* const* argv, int out, int limit, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  rlimit now{};
  if (limit > 0 && getrlimit(RLIMIT_CPU, &now) == 0) {
    // Where both are the same it is killed, and cannot make anything else of it as of SIGXCPU.
    const rlim_t seconds = std::min(static_cast<rlim_t>(limit), now.rlim_max);
    const rlimit wanted{seconds, seconds};
    setrlimit(RLIMIT_CPU, &wanted);
  }
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  execvp(argv[0], argv);
  _exit(127);
}

// Takes down what a program prints, to its end; false where it is to be ended before that.
bool read_all(int from, std::string& text, Clock::time_point patience) {
  std::string part(1 << 16, '\0');
  pollfd waiting{from, POLLIN, 0};
  while (InterruptGuard::signal() == 0 && Clock::now() < patience) {
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

}  // namespace

Ended run_program(const std::vector<std::string>& words, int limit) {
  const InterruptGuard interrupts;
  InterruptGuard::check();
  std::vector<char*> argv;
  for (const std::string& w : words) argv.push_back(const_cast<char*>(w.c_str()));
  argv.push_back(nullptr);
  int ends[2] = {-1, -1};
  const pid_t parent = getpid();
  const pid_t child = pipe2(ends, O_CLOEXEC) == 0 ? fork() : -1;
  if (child < 0) throw InputError(words.front() + ": cannot be run: " + std::strerror(errno));
  if (child == 0) become(argv.data(), ends[1], limit, parent);
  close(ends[1]);

  Ended ended;
  const auto patience = limit == 0 ? Clock::time_point::max()
                                   : Clock::now() + std::chrono::seconds(1LL * kPatience * limit);
  const bool to_its_end = read_all(ends[0], ended.text, patience);
  if (!to_its_end) kill(child, SIGKILL);
  close(ends[0]);
  int status = 0;
  rusage used{};
  while (wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  InterruptGuard::check();
  ended.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  ended.seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  // The limit is kept in ticks of the clock, and may come a little early.
  const bool out_of_time = ended.status == 128 + SIGKILL && ended.seconds > 0.5 * limit;
  ended.timed_out = !to_its_end || (limit > 0 && out_of_time);
  return ended;
}

Scratch::Scratch() {
  const char* folder = std::getenv("TMPDIR");
  std::string name = std::string(folder != nullptr ? folder : "/tmp") + "/cosim.XXXXXX";
  if (mkdtemp(name.data()) == nullptr) {
    throw InputError(name + ": cannot be made: " + std::strerror(errno));
  }
  path_ = name;
}
Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace cosim
