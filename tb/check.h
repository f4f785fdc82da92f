// What the machines drew, against the oracles: a second opinion beside lockstep, on whole jobs.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "model/circular/host.h"
#include "model/linear/host.h"
#include "tb/bench.h"

namespace cosim {

/// What a check found of a run of jobs.
struct Checked {
  std::uint64_t jobs = 0;   ///< finished
  std::uint64_t steps = 0;  ///< elementary steps: positions of a line, clocks with a step of an arc
  double max_deviation = 0;  ///< in steps, from the exact line or circle, over all jobs
  std::string error;         ///< empty, or one line: the first place where machine and oracle part
};

/// Compares each pair of words with the oracle, and the number of words.
class LineCheck final : public Observer<linear::Design> {
 public:
  LineCheck(const linear::Params& p, std::span<const linear::Job> jobs) : p_(p), jobs_(jobs) {}
  void clock(std::size_t job, const Compared<linear::Design>& seen) override;
  /// What was found so far, the present job left open.
  const Checked& so_far() const { return found_; }
  /// Closes the last job.
  Checked finish();

 private:
  void close();
  linear::Params p_;
  std::span<const linear::Job> jobs_;
  std::size_t job_ = 0;
  std::int64_t tick_ = 0;
  Checked found_;
};

/// Compares each step with the oracle, the number of steps and the last point.
class ArcCheck final : public Observer<circular::Design> {
 public:
  explicit ArcCheck(std::span<const circular::Arc> arcs);
  void clock(std::size_t job, const Compared<circular::Design>& seen) override;
  /// What was found so far, the present job left open.
  const Checked& so_far() const { return found_; }
  /// Closes the last job.
  Checked finish();

 private:
  void open();
  void close();
  std::span<const circular::Arc> arcs_;
  std::size_t job_ = 0;
  std::int64_t steps_ = 0;
  circular::Point at_;
  Checked found_;
};

}  // namespace cosim
