#include "tests/cli/program.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>
#include <utmp.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/support/child.h"

namespace cosim::cli {
namespace {

using test::Child, test::Stream;

// Else a failure is printed for GitHub's log, too.
[[maybe_unused]] const int outside_github = unsetenv("GITHUB_ACTIONS");

Ended run(const char* program, const Arguments& arguments, const Output& output) {
  const Folder folder;
  const auto kind = [](bool closed) { return closed ? Stream::closed : Stream::file; };
  Child child(program, arguments,
              {Stream::file, kind(output.closed), kind(output.err_closed),
               output.path.empty() ? folder.path("out") : output.path,
               output.err_path.empty() ? folder.path("err") : output.err_path});
  Ended ended;
  ended.status = child.status();
  ended.peak = child.peak();
  if (output.path.empty() && !output.closed) ended.out = folder.text("out");
  ended.err = folder.text("err");
  return ended;
}

// A patience of 0 has no end.
Ended signalled(const char* program, const Arguments& arguments, int signal, int after,
                const std::function<bool(const Folder&)>& ready, int patience = 0) {
  constexpr std::chrono::milliseconds step(5);
  const Folder folder;
  Child child(program, arguments, {.out_path = folder.path("out"), .err_path = folder.path("err")});
  for (std::chrono::milliseconds waited{0}; waited.count() < after; waited += step) {
    if (ready(folder) || child.ends_within(step)) break;
  }
  child.signal(signal);
  if (patience != 0 && !child.ends_within(std::chrono::milliseconds(patience))) {
    child.signal(SIGKILL);
  }
  Ended ended;
  ended.status = child.status();
  ended.out = folder.text("out");
  ended.err = folder.text("err");
  return ended;
}

}  // namespace

Ended ends(int status, Ended ended, const char* file, int line) {
  if (ended.status != status) {
    ADD_FAILURE_AT(file, line) << "status " << ended.status << " in place of " << status << ": "
                               << ended.out << ended.err;
  }
  return ended;
}

std::string refusal(const Ended& ended, const char* file, int line) {
  EXPECT_EQ(lines(ended.err).size(), 1U) << ended.err;
  return ends(2, ended, file, line).err;
}

Ended cosim(const Arguments& arguments, const Output& output) {
  return run(COSIM_PROGRAM, arguments, output);
}

bool cosim_killed(const Arguments& arguments, int after) {
  return cosim_signalled(arguments, SIGKILL, after).status == 128 + SIGKILL;
}

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

Ended small_cosim(const Arguments& arguments) { return run(COSIM_SMALL_PROGRAM, arguments, {}); }

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
  int terminal = -1, inside = -1;
  if (openpty(&terminal, &inside, nullptr, nullptr, &size) != 0) {
    throw std::runtime_error("no pseudo-terminal after all");
  }
  Child child(COSIM_PROGRAM, arguments, {}, [&] {
    close(terminal);
    login_tty(inside);
  });
  close(inside);
  Ended ended;
  std::string part(4096, '\0');
  // A terminal whose last writer is gone gives an error, not an end.
  for (ssize_t n = 0; (n = ::read(terminal, part.data(), part.size())) > 0;) {
    ended.out.append(part, 0, static_cast<std::size_t>(n));
  }
  ended.status = child.status();
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
