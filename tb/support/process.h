// Other programs, run to their end. None outlives this one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tb/support/interrupt.h"

namespace cosim {

struct Ended {
  int status = 0;          ///< 127 where there is no such program, 128 + n where signal n ended it
  bool timed_out = false;  ///< it was stopped at its limit
  double seconds = 0;      ///< of processor time that it took
  std::string text;        ///< what it printed, errors among it
};

/// Runs a program, found as a shell finds it, with nothing to read. After `limit` seconds of
/// processor time, which a busy computer does not take from it, it is stopped; 0 is no limit. One
/// that waits instead of working is stopped as well, after many times that.
/// Where SIGINT or SIGTERM come the program is ended, and Interrupted thrown.
Ended run_program(const std::vector<std::string>& words, int limit = 0);

/// A folder for files in between, gone with this: where SIGINT or SIGTERM come, too.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  InterruptGuard interrupts_;
  std::filesystem::path path_;
};

}  // namespace cosim
