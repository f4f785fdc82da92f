// What the checks of designs that draw paths share: jobs come one after the other, each is opened,
// compared clock by clock and closed, and the first error ends the comparing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

#include "tb/bench/bench.h"
#include "tb/bench/checked.h"

namespace cosim {

/// Of one path or of several.
struct PathFigures {
  std::uint64_t steps = 0;
  double max_deviation = 0;

  void add(const PathFigures& more) {
    steps += more.steps;
    max_deviation = std::max(max_deviation, more.max_deviation);
  }
  Checked checked() const {
    Checked found;
    found.measures = {
        {"steps", Measure::Sum::total, "", "step", steps},
        {"max_deviation", Measure::Sum::largest, "largest deviation", "step", max_deviation}};
    return found;
  }
};

template <class Design>
class PathCheck : public Observer<Design> {
 public:
  using Job = typename HostOf<Design>::Job;

  explicit PathCheck(std::span<const Job> jobs) : jobs_(jobs) {}
  void clock(std::size_t job, const Compared<Design>& seen) final {
    while (job_ < job) close_one();
    open_one();
    if (found_.error.empty()) compare(jobs_[job], seen);
  }
  /// What was found so far, the present job left open.
  Checked so_far() const {
    Checked found = figures_.checked();
    found.jobs = found_.jobs;
    found.error = found_.error;
    return found;
  }
  /// Closes the last job.
  Checked finish() {
    while (job_ < jobs_.size()) close_one();
    return so_far();
  }

 protected:
  void fail(std::string error) { found_.error = std::move(error); }
  void drew(std::uint64_t steps) { figures_.add({steps, 0}); }
  void deviates(double steps) { figures_.add({0, steps}); }

 private:
  virtual void open(const Job& job) = 0;
  /// These two are called until one of them fails.
  virtual void compare(const Job& job, const Compared<Design>& seen) = 0;
  virtual void close(const Job& job) = 0;

  void open_one() {
    if (!open_) open(jobs_[job_]);
    open_ = true;
  }
  void close_one() {
    open_one();
    if (found_.error.empty()) close(jobs_[job_]);
    ++found_.jobs;
    ++job_;
    open_ = false;
  }

  std::span<const Job> jobs_;
  std::size_t job_ = 0;
  bool open_ = false;
  Checked found_;
  PathFigures figures_;
};

}  // namespace cosim
