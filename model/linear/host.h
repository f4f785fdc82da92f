// The device outside, SU 1631518: writes BP and UK, starts the line, waits for its end.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/linear/control_code.h"
#include "model/linear/drive.h"
#include "model/linear/view.h"

namespace cosim::linear {

/// A line for the host to draw.
struct Job {
  Line line;
  /// Give the line up through input 17 after so many words, >= 0; a number past the end of the
  /// line gives nothing up.
  std::optional<std::int64_t> words;
};

/// Drives the machine's pins through a list of lines, one after the other. A line takes three
/// clocks to write and start, one until its first word, one a word and one to see the end.
class Host {
 public:
  using Job = linear::Job;

  /// `jobs` must outlive the host.
  Host(const Params& p, std::span<const Job> jobs) : p_(p), jobs_(jobs) {}

  /// The inputs of the next clock; false when the last line is over. `seen`: the outputs of the
  /// clock before (of no meaning on the first call).
  bool next(Inputs<Word>& in, const Outputs<Word>& seen);

  /// Simpler lines to try in place of a line that shows a fault, the simplest first. Each is
  /// smaller in one respect and larger in none.
  static std::vector<Job> smaller(const Params& p, const Job& job);
  /// "BP = 27, UK = 01010"
  static std::string describe(const Params& p, const Job& job);

  /// The line that the last inputs belong to, from 0.
  std::size_t job() const { return job_; }

 private:
  Params p_;
  std::span<const Job> jobs_;
  std::size_t job_ = 0;
  bool is_first_ = true;
  Task<Word> task_;
  Driven<Word> driven_;
};

}  // namespace cosim::linear
