#include "tests/cli/program.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/cli/folder.h"

namespace cosim::cli {
namespace {

// Replaces this process. _exit, for the tests' own buffers are not to be written twice.
[[noreturn]] void become(const char* program, const Arguments& arguments) {
  std::vector<char*> argv{const_cast<char*>(program)};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  execv(program, argv.data());
  _exit(126);
}

void send(int stream, const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || dup2(file, stream) < 0) _exit(125);
  close(file);
}

int status_of(pid_t child, long* peak = nullptr) {
  int status = 0;
  rusage used{};
  if (wait4(child, &status, 0, &used) != child) throw std::runtime_error("wait4");
  if (peak != nullptr) *peak = used.ru_maxrss * 1024;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

// An empty path closes the stream.
void redirect(int stream, const std::string& path) {
  if (path.empty()) {
    close(stream);
  } else {
    send(stream, path);
  }
}

pid_t start(const char* program, const Arguments& arguments, const std::string& out,
            const std::string& err) {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork");
  if (child != 0) return child;
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  redirect(STDERR_FILENO, err);
  redirect(STDOUT_FILENO, out);
  become(program, arguments);
}

Ended run(const char* program, const Arguments& arguments, const Output& output) {
  const Folder folder;
  const std::string out = output.path.empty() ? folder.path("out") : output.path;
  const std::string err = output.err_path.empty() ? folder.path("err") : output.err_path;
  Ended ended;
  ended.status =
      status_of(start(program, arguments, output.closed ? "" : out, output.err_closed ? "" : err),
                &ended.peak);
  if (output.path.empty() && !output.closed) ended.out = folder.text("out");
  ended.err = folder.text("err");
  return ended;
}

}  // namespace

Ended cosim(const Arguments& arguments, const Output& output) {
  return run(COSIM_PROGRAM, arguments, output);
}

bool cosim_killed(const Arguments& arguments, int after) {
  const pid_t child = start(COSIM_PROGRAM, arguments, "/dev/null", "/dev/null");
  std::this_thread::sleep_for(std::chrono::milliseconds(after));
  kill(child, SIGKILL);
  return status_of(child) == 128 + SIGKILL;
}

namespace {

constexpr std::chrono::milliseconds step(5);

Ended signalled(const char* program, const Arguments& arguments, int signal, int after,
                const std::function<bool(const Folder&)>& ready, int patience = 0) {
  const Folder folder;
  const pid_t child = start(program, arguments, folder.path("out"), folder.path("err"));
  for (std::chrono::milliseconds waited{0}; waited.count() < after; waited += step) {
    if (ready(folder)) break;
    std::this_thread::sleep_for(step);
  }
  kill(child, signal);
  siginfo_t end{};
  for (std::chrono::milliseconds waited{0}; waited.count() < patience; waited += step) {
    if (waitid(P_PID, static_cast<id_t>(child), &end, WEXITED | WNOHANG | WNOWAIT) != 0) break;
    if (end.si_pid == child) break;
    std::this_thread::sleep_for(step);
  }
  if (patience != 0 && end.si_pid != child) kill(child, SIGKILL);
  Ended ended;
  ended.status = status_of(child);
  ended.out = folder.text("out");
  ended.err = folder.text("err");
  return ended;
}

}  // namespace

Ended cosim_signalled(const Arguments& arguments, int signal, int after, Until until) {
  return signalled(COSIM_PROGRAM, arguments, signal, after, [until](const Folder& folder) {
    return until == Until::a_line && folder.text("out").find('\n') != std::string::npos;
  });
}

Ended cosim_signalled(const Arguments& arguments, int signal, const std::function<bool()>& ready) {
  return signalled(COSIM_PROGRAM, arguments, signal, 600'000,
                   [&](const Folder&) { return ready(); });
}

Ended faulty_signalled(const Arguments& arguments, int signal, const std::function<bool()>& ready) {
  return signalled(
      COSIM_FAULTY_PROGRAM, arguments, signal, 600'000, [&](const Folder&) { return ready(); },
      60'000);
}

Ended another_build(const Arguments& arguments) {
  const Folder folder;
  const std::string copy = folder.path("cosim");
  std::filesystem::copy_file(COSIM_PROGRAM, copy);
  std::ofstream(copy, std::ios::app) << '+';
  return run(copy.c_str(), arguments, {});
}

Ended faulty(const Arguments& arguments) { return run(COSIM_FAULTY_PROGRAM, arguments, {}); }

Ended variant(const Arguments& arguments) { return run(COSIM_VARIANT_PROGRAM, arguments, {}); }

bool has_terminals() {
  int ends[2];
  if (openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) != 0) return false;
  close(ends[0]);
  close(ends[1]);
  return true;
}

Ended cosim_on_terminal(const Arguments& arguments, unsigned short columns) {
  winsize size{};
  size.ws_row = 24;
  size.ws_col = columns;
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
  if (child < 0) throw std::runtime_error("no pseudo-terminal after all");
  if (child == 0) become(COSIM_PROGRAM, arguments);
  Ended ended;
  std::string part(4096, '\0');
  // A terminal whose last writer is gone gives an error, not an end.
  for (ssize_t n = 0; (n = ::read(terminal, part.data(), part.size())) > 0;) {
    ended.out.append(part, 0, static_cast<std::size_t>(n));
  }
  ended.status = status_of(child);
  close(terminal);
  return ended;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

}  // namespace cosim::cli
