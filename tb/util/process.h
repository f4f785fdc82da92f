// Other programs, run to their end. None outlives this one, nor do those of its process group
// outlive it.
#pragma once

#include <atomic>
#include <chrono>
#include <string>
#include <vector>

#include "tb/util/scratch.h"

namespace cosim {

struct Ended {
  int status = 0;          ///< 127 where there is no such program, 128 + n where signal n ended it
  bool timed_out = false;  ///< it was stopped at its limit
  double seconds = 0;      ///< of processor time that it took
  std::string text;        ///< what it printed, errors included
};

/// Runs a program, found as a shell finds it, with nothing to read. `env` may stand before it, with
/// "-C FOLDER", "-u NAME" and "NAME=VALUE". After `limit` seconds of processor time it is stopped;
/// 0 is no limit. A program that only waits is stopped after many times the limit, and as at its
/// limit when `no_more` becomes true. What it leaves running when it ends is ended; TMPDIR is a
/// folder of its own, removed with it. When interrupted (interrupt.h) the program is stopped and
/// Interrupted is thrown. InputError where no room is left for temporary files: what the program
/// says then is of no use.
Ended run_program(const std::vector<std::string>& words, int limit = 0,
                  const std::atomic<bool>* no_more = nullptr);

/// The same without a limit of processor time: it is stopped, `timed_out`, when it is `until`.
Ended run_until(const std::vector<std::string>& words, std::chrono::steady_clock::time_point until,
                const std::atomic<bool>* no_more = nullptr);

/// The same without a limit, to its end even where this program is to end: what is left to be done
/// then. Status 127 where it cannot be run.
Ended run_all_the_same(const std::vector<std::string>& words);

/// Where a shell would find the program; "" where it would not. It is not run.
std::string path_of(const std::string& program);
inline bool is_installed(const std::string& program) { return !path_of(program).empty(); }

}  // namespace cosim
