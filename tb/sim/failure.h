// The folder that a mismatch leaves: all that is needed to understand it and to run it again.
//
//   report.txt       what and where, the clocks around it, the smallest case, how to replay
//   report.json      the same for a program, with `format`, the version of the folder's
//   report.html      the same as a page, with the waves around the difference
//   stimulus.stim    the inputs up to the difference and a little on
//   wave.fst         the clocks around it; wave.gtkw is its view for GTKWave
//   smallest.stim    the smallest stimulus found that still fails, with smallest.fst, .gtkw
#pragma once

#include <filesystem>
#include <string>

#include "tb/sim/bench.h"

namespace cosim {

struct FailureOptions {
  std::filesystem::path root = "failures";
  Window wave = wave_window;
};

/// What is left of a failure.
struct Failure {
  std::filesystem::path folder;
  std::string smallest;  ///< the smallest case and the size of the smallest stimulus, lines
  std::string replay;    ///< the command that replays it
  std::string page;      ///< report.html
};

/// Writes root/<design>-<case>, from `what`, one line that names the case. The folder appears when
/// it is whole, and takes the place of one of the same name. InputError where it cannot be written.
Failure leave_failure(const AnyBench& bench, const std::string& what, const Mismatch& mismatch,
                      const FailureOptions& options = {});

/// The folder's name: design, parameters and case, of letters, digits, dots and dashes alone.
std::string failure_name(const AnyBench& bench, const std::string& what);

/// Lines for a person: the folder, the smallest case, the command. End in '\n'.
std::string to_text(const Failure& failure);

}  // namespace cosim
