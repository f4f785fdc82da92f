// The device outside: writes the registers for a curve, starts it, waits for its end or stops it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/dda/drive.h"
#include "model/dda/view.h"

namespace cosim::dda {

/// Drives the machine's pins through a list of jobs, one after the other. A job takes twelve clocks
/// to write and start, those it runs, and one or two to end.
class Host {
 public:
  using Job = dda::Job;

  /// `jobs` must outlive the host.
  Host(const Params& p, std::span<const Job> jobs) : p_(p), jobs_(jobs) {}

  /// The inputs of the next clock; false when the last job is over. `seen`: the outputs of the
  /// clock before (of no meaning on the first call).
  bool next(Inputs<Word>& in, const Outputs<Word>& seen);

  /// Simpler jobs to try in place of a job that shows a fault, the simplest first. Each is smaller
  /// in one respect and larger in none. Each of them ends.
  static std::vector<Job> smaller(const Params& p, const Job& job);
  /// "rates (27, 9) from (0, 0), 27 and 9 steps"
  static std::string describe(const Params& p, const Job& job);

  /// The job that the last inputs belong to, from 0.
  std::size_t job() const { return job_; }

 private:
  Params p_;
  std::span<const Job> jobs_;
  std::size_t job_ = 0;
  bool is_first_ = true;
  Task<Word> task_;
  Driven<Word> driven_;
};

}  // namespace cosim::dda
