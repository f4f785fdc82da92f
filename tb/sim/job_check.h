// What is to come of jobs, seen by a design's check on every clock that matched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "model/core/job.h"
#include "tb/sim/bench.h"
#include "tb/sim/checked.h"
#include "tb/sim/lockstep.h"

namespace cosim {

/// What is measured of jobs beside their check: nothing.
template <class Design>
struct NoFigures {
  using Params = typename Design::Params;
  using Job = JobOf<Design>;
  using Checker = CheckerOf<Design, Word>;
  /// The first cell of the checker that end_in_lane() reads.
  static constexpr std::size_t first = Checker::size;
  /// A clock of a job, and the checker after it.
  void clock(const Params&, const Job&, const Checker&,
             const typename Design::template Outputs<Word>&) {}
  /// The end of a job whose clocks were seen.
  void end(const Params&, const Job&, const Checker&) {}
  /// Of one that ran in a lane, unseen.
  void end_in_lane(const Params&, const Job&, const Checker&) {}
  /// Counts no jobs.
  Checked checked() const { return {}; }
};

/// Counts the jobs that were driven to their end and, where the design has a check, keeps what it
/// first found wrong: "idle=3 byte=65, clock 7: checked since=0 byte=0, and then ready=1 tx=1".
/// Figures measures, and has what NoFigures has.
template <class Design, class Figures = NoFigures<Design>>
class JobCheck final : public Observer<Design> {
 public:
  using Job = JobOf<Design>;
  using Driver = DriverOf<Design, Word>;
  using Checker = CheckerOf<Design, Word>;

  /// `jobs` must outlive it.
  JobCheck(const typename Design::Params& p, std::span<const Job> jobs)
      : p_(p), jobs_(jobs), held_driver_(Driver::fields(p)), held_checker_(Checker::fields(p)) {}

  COSIM_FLATTEN void clock(std::size_t job, const Compared<Design>& seen) override {
    if (clock_ == 0) begin(jobs_[job]);
    const auto turn = driven(p_, task_, driver_, seen.outputs);
    if constexpr (has_check<Design>) {
      const auto verdict = checked(p_, task_, driver_, checker_, seen.outputs, turn.over);
      if (verdict.wrong) fail(job, seen);
      checker_ = held_checker_.of(verdict.checker);
    }
    driver_ = held_driver_.of(turn.driver);
    figures_.clock(p_, jobs_[job], checker_, seen.outputs);
    ++clock_;
    if (turn.over) end(jobs_[job]);
  }
  Checked so_far() const {
    Checked found = figures_.checked();
    found.jobs = jobs_over_;
    found.error = error_;
    return found;
  }

 private:
  // Once a job, and not part of each clock.
  [[gnu::noinline]] void begin(const Job& job) {
    task_ = task_for<Design>(p_, job);
    driver_ = driver_for<Design, Word>(p_);
    checker_ = checker_for<Design>(p_, job);
  }
  [[gnu::noinline]] void end(const Job& job) {
    figures_.end(p_, job, checker_);
    ++jobs_over_;
    clock_ = 0;
  }
  [[gnu::cold, gnu::noinline]] void fail(std::size_t job, const Compared<Design>& seen) {
    if (!error_.empty()) return;
    error_ = JobHost<Design>::describe(p_, jobs_[job]) + ", clock " + std::to_string(clock_) +
             ": checked " + detail::named_values(p_, checker_) + ", and then " +
             detail::named_values(p_, seen.outputs);
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
  Held<Driver> held_driver_;
  [[maybe_unused]] Held<Checker> held_checker_;
};

}  // namespace cosim
