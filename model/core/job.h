// Jobs: what a design is given to do as a whole. The device outside, which drives the pins through
// one, and the check of what comes of it are step functions over a value type, as a model is: on
// machine integers they run one machine, on bits of gates as many as there are lanes. A design with
// jobs has
//
//   Job<V>                a record: the numbers of a job (job_table.h)
//   Driver<V>             a record: what the driver goes on from; all 0 as a job begins, or
//                         Driver<Word> driver_of(p)
//   Inputs<V> drive(p, job, driver, rest)            of the next clock; `rest`: those at rest
//   Turn<Driver, V> driven(p, job, driver, out)      after a clock with these outputs
//
// and, where it checks more than RTL against model,
//
//   Checker<V>            a record: what the check goes on from; all 0 as a job begins, or
//                         Checker<Word> checker_of(p, job)
//   Verdict<Checker, V> checked(p, job, driver, checker, out, over)
//                         of a clock with these outputs, the last one of its job where it is `over`
//
// Where jobs are no such table, Job is a type of the design's own, and there are
//
//   Task<V>, Task<Word> task_of(p, job)              a record: what these are told in place of job
//   std::vector<Job> smaller(p, job)                 to try where a job fails, the simplest first
//   std::string describe(p, job)                     in one line
//
// struct Design has the types; the functions are found by their arguments. None knows the clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/core/input_error.h"
#include "model/core/job_table.h"
#include "model/core/value.h"

namespace cosim {

/// What the driver goes on from after a clock, and whether that was the job's last one. Then the
/// next job begins, whatever is said of it here.
template <template <class> class Driver, class V>
struct Turn {
  Driver<V> driver;
  Condition<V> over;
};

template <template <class> class Checker, class V>
struct Verdict {
  Checker<V> checker;  ///< after the clock
  Condition<V> wrong;  ///< what the clock shows is not what is due
};

template <class Design>
constexpr auto rest_of();

template <class Design>
concept HasJobs = requires {
  typename Design::template Driver<Word>;
};
/// By a table.
template <class Design>
concept DeclaresJobs = HasJobs<Design> && requires {
  typename Design::template Job<Word>;
};
template <class Design>
inline constexpr bool has_check = requires {
  typename Design::template Checker<Word>;
};

/// The record of a design without a check.
template <class V>
struct NoChecker {
  static constexpr std::size_t size = 0;
  template <class Visit>
  static constexpr void each_member(Visit&) {}
  template <class Params>
  static constexpr std::array<Field, 0> fields(const Params&) {
    return {};
  }
};

namespace detail {

template <class Design>
struct JobTypes {
  using Job = typename Design::Job;
  template <class V>
  using Task = typename Design::template Task<V>;
};
template <DeclaresJobs Design>
struct JobTypes<Design> {
  using Job = typename Design::template Job<Word>;
  template <class V>
  using Task = typename Design::template Job<V>;
};
template <class Design>
struct CheckerTypes {
  template <class V>
  using Checker = NoChecker<V>;
};
template <class Design>
requires has_check<Design>
struct CheckerTypes<Design> {
  template <class V>
  using Checker = typename Design::template Checker<V>;
};

// Not in the class below: its own functions of these names would hide them.
template <class Design, class Job>
std::vector<Job> smaller_jobs(const typename Design::Params& p, const Job& job) {
  if constexpr (DeclaresJobs<Design>) {
    return smaller_of_table(p, job);
  } else {
    return smaller(p, job);
  }
}
template <class Design, class Job>
std::string description_of(const typename Design::Params& p, const Job& job) {
  if constexpr (DeclaresJobs<Design>) {
    return named_values(p, job);
  } else {
    return describe(p, job);
  }
}

}  // namespace detail

template <class Design>
using JobOf = typename detail::JobTypes<Design>::Job;
template <class Design, class V>
using TaskOf = typename detail::JobTypes<Design>::template Task<V>;
template <class Design, class V>
using DriverOf = typename Design::template Driver<V>;
template <class Design, class V>
using CheckerOf = typename detail::CheckerTypes<Design>::template Checker<V>;

template <class Design>
TaskOf<Design, Word> task_for(const typename Design::Params& p, const JobOf<Design>& job) {
  if constexpr (DeclaresJobs<Design>) {
    return job;
  } else {
    return task_of(p, job);
  }
}
template <class Design>
CheckerOf<Design, Word> checker_for(const typename Design::Params& p, const JobOf<Design>& job) {
  if constexpr (requires { checker_of(p, job); }) {
    return checker_of(p, job);
  } else {
    return {};
  }
}

/// The driver as a job begins.
template <class Design, class V>
DriverOf<Design, V> driver_for([[maybe_unused]] const typename Design::Params& p) {
  DriverOf<Design, V> driver{};
  if constexpr (requires { driver_of(p); }) {
    const auto words = to_words(driver_of(p));
    for_each_cell<DriverOf<Design, V>>(
        [&](auto cell, std::size_t i) { cell(driver) = V(words[i]); });
  }
  return driver;
}

/// What the fields of such a record hold of numbers: their lowest bits, as in lanes.
template <class Record>
class Held {
 public:
  explicit constexpr Held(const std::array<Field, Record::size>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      codes_[i] = ones(fields[i].width);
      signs_[i] = is_signed(fields[i]) ? codes_[i] ^ codes_[i] >> 1 : 0;
    }
  }
  constexpr Record of(Record record) const {
    for_each_cell<Record>([&](auto cell, std::size_t i) {
      cell(record) = subtract((cell(record) & codes_[i]) ^ signs_[i], signs_[i]);
    });
    return record;
  }

 private:
  std::array<Word, Record::size> codes_{}, signs_{};  // all its bits, and the one of the sign
};

/// A job that is longer is taken for one that waits for ever: so many clocks, or
/// Design::most_clocks.
template <class Design>
constexpr std::uint64_t most_clocks_of() {
  if constexpr (requires { Design::most_clocks; }) {
    return Design::most_clocks;
  } else {
    return 1'000'000;
  }
}

/// Drives a machine's pins through a list of jobs, one after the other.
template <class Design>
class JobHost {
 public:
  using Job = JobOf<Design>;
  using Params = typename Design::Params;

  /// `jobs` must outlive the host.
  JobHost(const Params& p, std::span<const Job> jobs)
      : p_(p), jobs_(jobs), held_(DriverOf<Design, Word>::fields(p)) {}

  /// The inputs of the next clock; false when the last job is over. `seen`: the outputs of the
  /// clock before (of no meaning on the first call). InputError where a job is too long.
  bool next(typename Design::template Inputs<Word>& in,
            const typename Design::template Outputs<Word>& seen) {
    bool begins = is_first_;
    if (!is_first_) {
      const auto turn = driven(p_, task_, driver_, seen);
      driver_ = held_.of(turn.driver);
      begins = turn.over;
      job_ += turn.over;
    }
    if (job_ == jobs_.size()) return false;
    if (begins) {
      task_ = task_for<Design>(p_, jobs_[job_]);
      driver_ = driver_for<Design, Word>(p_);
      clocks_ = 0;
    }
    if (++clocks_ > most_clocks_of<Design>()) refuse_endless();
    in = drive(p_, task_, driver_, rest_of<Design>());
    is_first_ = false;
    return true;
  }

  /// Simpler jobs to try in place of one that shows a fault, the simplest first.
  static std::vector<Job> smaller(const Params& p, const Job& job) {
    return detail::smaller_jobs<Design>(p, job);
  }
  /// "idle=3 byte=65"
  static std::string describe(const Params& p, const Job& job) {
    return detail::description_of<Design>(p, job);
  }

  /// The job that the last inputs belong to, from 0.
  std::size_t job() const { return job_; }

 private:
  [[noreturn, gnu::cold, gnu::noinline]] void refuse_endless() const {
    throw InputError("the driver of " + describe(p_, jobs_[job_]) + " has not ended after " +
                     std::to_string(most_clocks_of<Design>()) + " clocks");
  }

  Params p_;
  std::span<const Job> jobs_;
  std::size_t job_ = 0;
  std::uint64_t clocks_ = 0;  // of this job
  bool is_first_ = true;
  TaskOf<Design, Word> task_{};
  DriverOf<Design, Word> driver_{};
  Held<DriverOf<Design, Word>> held_;
};

}  // namespace cosim
