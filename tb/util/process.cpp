#include "tb/util/process.h"

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

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

using Clock = std::chrono::steady_clock;

// Seconds that may go by for each one of processor time.
constexpr int kPatience = 20;
// How soon a signal to this program is heeded, which may come to any of its threads.
constexpr int kMilliseconds = 50;

// Solvers and synthesizers take memory and give it back all the time: in a heap that grows by much
// and is never cut, of large pages, a proof takes three fifths of the time. Other libraries than
// glibc do not read this.
constexpr const char* large_heap =
    "glibc.malloc.top_pad=67108864:glibc.malloc.trim_threshold=268435456:"
    "glibc.malloc.mmap_threshold=33554432:glibc.malloc.hugetlb=1";

// What is run, and where; an `env` in front is done here, for it takes as long as a small program.
struct Called {
  std::vector<std::string> words, environment;
  std::string folder;  // "" is this one's
};

Called called(const std::vector<std::string>& words, const std::string& temporary) {
  std::vector<std::string> unset{"TMPDIR"}, set{"TMPDIR=" + temporary};
  if (getenv("GLIBC_TUNABLES") == nullptr)
    set.push_back(fmt::format("GLIBC_TUNABLES={}", large_heap));
  Called is;
  std::size_t first = 0;
  if (words.front() == "env") {
    for (first = 1; first + 1 < words.size(); ++first) {
      if (words[first] == "-C") {
        is.folder = words[++first];
      } else if (words[first] == "-u") {
        unset.push_back(words[++first]);
      } else if (const std::size_t end = words[first].find('='); end != std::string::npos) {
        const std::string name = words[first].substr(0, end);
        std::erase_if(set, [&](const std::string& one) { return one.starts_with(name + '='); });
        unset.push_back(name);
        set.push_back(words[first]);
      } else {
        break;
      }
    }
  }
  is.words.assign(words.begin() + static_cast<std::ptrdiff_t>(first), words.end());
  for (char** one = environ; *one != nullptr; ++one) {
    const std::string_view variable(*one);
    if (std::ranges::find(unset, variable.substr(0, variable.find('='))) == unset.end()) {
      is.environment.emplace_back(variable);
    }
  }
  is.environment.insert(is.environment.end(), set.begin(), set.end());
  return is;
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> list;
  for (const std::string& w : words) list.push_back(const_cast<char*>(w.c_str()));
  list.push_back(nullptr);
  return list;
}

// Begins the program, in a process group of its own: what a terminal sends to this program is
// handed on by it. What runs before it in the child may take no memory, for this program may have
// several threads.
pid_t begin(const Called& is, int out, int limit) {
  const std::vector<char*> argv = pointers(is.words), variables = pointers(is.environment);
  sigset_t every, before;
  sigfillset(&every);
  pthread_sigmask(SIG_SETMASK, &every, &before);  // no handler of this program runs in the child
  const pid_t parent = getpid(), child = fork();
  if (child != 0) {
    const int error = errno;
    if (child > 0) setpgid(child, child);  // whichever of both comes first
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    errno = error;
    return child;
  }
  setpgid(0, 0);
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGALRM, SIGXCPU}) {
    if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  // Nobody is to wait for the end of a file, or for a lock, because of it.
  close_range(STDERR_FILENO + 1, ~0U, 0);
  if (!is.folder.empty() && chdir(is.folder.c_str()) != 0) _exit(127);
  rlimit now{};
  if (limit > 0 && getrlimit(RLIMIT_CPU, &now) == 0) {
    // Where both are the same it is killed, and cannot make anything else of it as of SIGXCPU.
    const rlim_t seconds = std::min(static_cast<rlim_t>(limit), now.rlim_max);
    const rlimit wanted{seconds, seconds};
    setrlimit(RLIMIT_CPU, &wanted);
  }
  execvpe(argv[0], argv.data(), variables.data());
  _exit(127);
}

// It stays as a zombie, so that its number is nobody else's.
bool has_ended(pid_t child) {
  siginfo_t ended{};
  return waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         ended.si_pid == child;
}

// Takes down what a program prints, to its end; false where it is to be ended before that.
bool read_all(int from, pid_t child, std::string& text, Clock::time_point patience,
              const std::atomic<bool>* no_more, bool heeds) {
  std::string part(1 << 16, '\0');
  pollfd waiting{from, POLLIN, 0};
  while ((!heeds || InterruptGuard::signal() == 0) && Clock::now() < patience &&
         (no_more == nullptr || !*no_more)) {
    if (poll(&waiting, 1, kMilliseconds) <= 0) {
      if (has_ended(child)) return true;  // what it left behind holds the pipe
      continue;
    }
    const ssize_t n = ::read(from, part.data(), part.size());
    if (n == 0 || (n < 0 && errno != EINTR)) return true;
    if (n > 0) text.append(part, 0, static_cast<std::size_t>(n));
  }
  return false;
}

// Ends it and its group. One such as ninja ends its own jobs, in groups of theirs, where it is
// given the time.
void end_group(pid_t child) {
  constexpr int moments = 100;
  kill(-child, SIGTERM);
  for (int i = 0; i < moments && !has_ended(child); ++i) poll(nullptr, 0, 10);
  kill(-child, SIGKILL);
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
  const bool is_open = pipe2(ends, O_CLOEXEC) == 0;
  const pid_t child = is_open ? begin(called(words, scratch.path()), ends[1], limit) : -1;
  if (child < 0) throw InputError(words.front() + ": cannot be run: " + std::strerror(errno));
  close(ends[1]);

  Ended ended;
  const bool to_its_end = read_all(ends[0], child, ended.text, until, no_more, heeds);
  if (!to_its_end) end_group(child);
  close(ends[0]);
  siginfo_t is{};
  while (waitid(P_PID, static_cast<id_t>(child), &is, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
  kill(-child, SIGKILL);  // what it left running
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
  const auto patience = limit == 0 ? Clock::time_point::max()
                                   : Clock::now() + std::chrono::seconds(1LL * kPatience * limit);
  const InterruptGuard interrupts;
  InterruptGuard::check();
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

std::string path_of(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = (folder.empty() ? "." : folder) + '/' + program;
    if (access(file.c_str(), X_OK) == 0) return file;
  }
  return "";
}

}  // namespace cosim
