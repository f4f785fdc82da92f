// What is to come of jobs, seen by a design's check on every clock that matched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "model/core/job.h"
#include "tb/bench/bench.h"
#include "tb/bench/checked.h"

namespace cosim {

/// What is taken of jobs beside their check: nothing.
template <class Design>
struct NoFigures {
  static constexpr std::size_t first = CheckerOf<Design, Word>::size;
  void add(const typename Design::Params&, const JobOf<Design>&, const CheckerOf<Design, Word>&) {}
  Checked checked() const { return {}; }
};

/// Counts the jobs that were driven to their end and, where the design has a check, keeps what it
/// first found wrong: "idle=3 byte=65, clock 7: checked since=0 byte=0, and then ready=1 tx=1".
///
/// Figures has, as NoFigures, the number of the checker's first cell that it reads, add(p, job,
/// checker) of a job at its end, and checked(), which counts no jobs.
template <class Design, class Figures = NoFigures<Design>>
class JobCheck final : public Observer<Design> {
 public:
  using Job = JobOf<Design>;
  using Driver = DriverOf<Design, Word>;
  using Checker = CheckerOf<Design, Word>;

  /// `jobs` must outlive it.
  JobCheck(const typename Design::Params& p, std::span<const Job> jobs)
      : p_(p),
        jobs_(jobs),
        driver_fields_(Driver::fields(p)),
        checker_fields_(Checker::fields(p)) {}

  void clock(std::size_t job, const Compared<Design>& seen) override {
    if (clock_ == 0) {
      task_ = task_for<Design>(p_, jobs_[job]);
      driver_ = {};
      checker_ = checker_for<Design>(p_, jobs_[job]);
    }
    const auto turn = driven(p_, task_, driver_, seen.outputs);
    if constexpr (has_check<Design>) {
      const auto verdict = checked(p_, task_, driver_, checker_, seen.outputs, turn.over);
      if (verdict.wrong) {
        fail(job, "checked " + detail::named_values(p_, checker_) + ", and then " +
                      detail::named_values(p_, seen.outputs));
      }
      checker_ = held_of(checker_fields_, verdict.checker);
    }
    driver_ = held_of(driver_fields_, turn.driver);
    ++clock_;
    if (!turn.over) return;
    figures_.add(p_, jobs_[job], checker_);
    ++jobs_over_;
    clock_ = 0;
  }
  Checked so_far() const {
    Checked found = figures_.checked();
    found.jobs = jobs_over_;
    found.error = error_;
    return found;
  }
  Checked finish() const { return so_far(); }

 private:
  void fail(std::size_t job, const std::string& why) {
    if (!error_.empty()) return;
    error_ = JobHost<Design>::describe(p_, jobs_[job]) + ", clock " + std::to_string(clock_) +
             ": " + why;
  }
  typename Design::Params p_;
  std::span<const Job> jobs_;
  std::string error_;
  Figures figures_;
  std::uint64_t jobs_over_ = 0;
  std::uint64_t clock_ = 0;  // of the job
  TaskOf<Design, Word> task_{};
  Driver driver_{};
  Checker checker_{};
  std::array<Field, Driver::size> driver_fields_;
  [[maybe_unused]] std::array<Field, Checker::size> checker_fields_;
};

}  // namespace cosim
