// A program that a test starts, with the streams it names, sends signals and waits for. Not by
// tb/util/process.h, which the program under test runs others by: a test sees from outside how a
// program ends.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace cosim::test {

enum class Stream { file, closed, full, gone };  ///< gone: a pipe that nobody reads

struct Streams {
  Stream in = Stream::file, out = Stream::file, err = Stream::file;  ///< in: /dev/null or closed
  std::string out_path = "/dev/null", err_path = "/dev/null";        ///< of those that are files
};

class Child {
 public:
  using milliseconds = std::chrono::milliseconds;

  /// `prepare` runs in the child, when the streams are as they are to be.
  Child(const std::string& program, const std::vector<std::string>& arguments,
        const Streams& streams, const std::function<void()>& prepare = {}) {
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    child_ = fork();
    if (child_ < 0) throw std::runtime_error("fork");
    if (child_ != 0) return;
    direct(streams.err, STDERR_FILENO, streams.err_path);
    direct(streams.out, STDOUT_FILENO, streams.out_path);
    direct(streams.in, STDIN_FILENO, "/dev/null");
    if (prepare) prepare();
    execv(argv[0], argv.data());
    _exit(126);  // for the test's own buffers are not to be written twice
  }

  /// Whether it ends, or has ended, in that time.
  bool ends_within(milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    for (auto nap = std::chrono::microseconds(500); !ended_; nap = std::min(2 * nap, longest_nap)) {
      if (wait(WNOHANG)) break;
      const auto left = end - std::chrono::steady_clock::now();
      if (left.count() <= 0) return false;
      std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(nap, left));
    }
    return true;
  }
  void signal(int number) const {
    if (!ended_) kill(child_, number);
  }
  /// Its status, at its end: 128 + n is a death by signal n.
  int status() {
    if (!ended_ && !wait(0)) throw std::runtime_error("wait4");
    return WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
  }
  /// The most memory that it had, in bytes; that of this process included, where it holds more.
  long peak() const { return used_.ru_maxrss * 1024; }

 private:
  static constexpr std::chrono::microseconds longest_nap{10'000};

  bool wait(int how) { return ended_ = wait4(child_, &status_, how, &used_) == child_; }

  static void direct(Stream kind, int stream, const std::string& path) {
    if (kind == Stream::closed) {
      close(stream);
      return;
    }
    int ends[2] = {-1, -1};
    if (kind == Stream::gone) {
      if (pipe(ends) != 0) _exit(125);
      close(ends[0]);
    } else {
      const char* name = kind == Stream::full ? "/dev/full" : path.c_str();
      ends[1] = stream == STDIN_FILENO ? open(name, O_RDONLY)
                                       : open(name, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    }
    if (ends[1] < 0 || dup2(ends[1], stream) < 0) _exit(125);
    if (ends[1] != stream) close(ends[1]);
  }

  pid_t child_ = -1;
  bool ended_ = false;
  int status_ = 0;
  rusage used_{};
};

}  // namespace cosim::test
