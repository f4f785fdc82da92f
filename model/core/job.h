// A job declared by one table: what a design is given to do, as numbers with ranges. From the table
// come random jobs, smaller ones in place of a failing one, their description and the words that
// name one on a command line. A table is a macro of rows
//
//   FIELD(name, low, high, meaning)
//
// whose ends may use p, the design's parameters. COSIM_JOB(Job, TABLE, Params) defines the struct.
// A design with jobs has two types, and may have a third:
//
//   struct Driver {                 // how one job is driven; made as Driver{p, job}
//     Params p; Job job;
//     /// The inputs of the job's next clock, which come in as rest(); false when the job is over:
//     /// that clock is the next job's first. `seen`: the outputs of the clock before.
//     bool next(Inputs<Word>& in, const Outputs<Word>& seen);
//   };
//   struct Check {                  // what is to come of one job; made as Check{p, job}
//     Params p; Job job;
//     /// Each clock of the job, in order.
//     void clock(const Outputs<Word>& out);
//     /// After the last: what came in place of what should, one line; empty where all is right.
//     std::string wrong() const;
//   };
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/core/fields.h"
#include "model/core/input_error.h"

namespace cosim {

struct JobField {
  const char* name;
  Word low, high;  ///< the ends of its range, both in it
  const char* meaning;
};

template <class Design>
constexpr auto rest_of();

/// Whether the design declares its jobs by a table.
template <class Design>
concept DeclaresJobs = requires {
  typename Design::Job;
  typename Design::Driver;
  Design::Job::size;
};

/// Calls visit(member, i) for each field's pointer to member, in the order of the table.
template <class Job, class Visit>
constexpr void for_each_job_field(Visit visit) {
  const auto members = Job::members();
  for (std::size_t i = 0; i < members.size(); ++i) visit(members[i], i);
}

/// The number nearest to 0 in a field's range: the simplest.
constexpr Word simplest(const JobField& field) {
  return std::clamp<Word>(0, field.low, field.high);
}

/// Drives the jobs of a design that declares them, one after the other.
template <class Design>
class JobHost {
 public:
  using Job = typename Design::Job;
  using Params = typename Design::Params;

  /// A job that is longer is taken for one that waits for ever.
  static constexpr std::uint64_t most_clocks = 1'000'000;

  /// `jobs` must outlive the host.
  JobHost(const Params& p, std::span<const Job> jobs) : p_(p), jobs_(jobs) {}

  /// The inputs of the next clock; false when the last job is over. `seen`: the outputs of the
  /// clock before (of no meaning on the first call). InputError where a job is too long.
  bool next(typename Design::template Inputs<Word>& in,
            const typename Design::template Outputs<Word>& seen) {
    for (; job_ < jobs_.size(); ++job_, driver_.reset(), clocks_ = 0) {
      if (!driver_) driver_.emplace(typename Design::Driver{p_, jobs_[job_]});
      in = rest_of<Design>();
      if (!driver_->next(in, seen)) continue;
      if (++clocks_ > most_clocks) refuse_endless();
      return true;
    }
    return false;
  }

  /// Jobs nearer to the simplest in one field and the same in all others, the simplest first.
  static std::vector<Job> smaller(const Params& p, const Job& job) {
    std::vector<Job> all;
    const auto fields = Job::fields(p);
    for_each_job_field<Job>([&](auto member, std::size_t i) {
      const Word least = simplest(fields[i]);
      const Word now = job.*member;
      for (const Word less : {least, least + (now - least) / 2, now < least ? now + 1 : now - 1}) {
        if (now == least || less == now) continue;
        all.push_back(job);
        all.back().*member = less;
      }
    });
    return all;
  }

  /// "idle=3 byte=65"
  static std::string describe(const Params& p, const Job& job) {
    std::string text;
    const auto fields = Job::fields(p);
    for_each_job_field<Job>([&](auto member, std::size_t i) {
      text += (text.empty() ? "" : " ") + (fields[i].name + ('=' + std::to_string(job.*member)));
    });
    return text;
  }

  /// The job that the last inputs belong to, from 0.
  std::size_t job() const { return job_; }

 private:
  [[noreturn, gnu::cold, gnu::noinline]] void refuse_endless() const {
    throw InputError("the driver of " + describe(p_, jobs_[job_]) + " has not ended after " +
                     std::to_string(most_clocks) + " clocks");
  }

  Params p_;
  std::span<const Job> jobs_;
  std::size_t job_ = 0;
  std::uint64_t clocks_ = 0;  // of this job
  std::optional<typename Design::Driver> driver_;
};

}  // namespace cosim

#define COSIM_JOB_MEMBER(name, low, high, meaning) ::cosim::Word name{};
#define COSIM_JOB_INDEX(name, low, high, meaning) index_##name,
#define COSIM_JOB_POINTER(name, low, high, meaning) &Self::name,
#define COSIM_JOB_FIELD(name, low, high, meaning) ::cosim::JobField{#name, low, high, meaning},

/// Defines `struct Job` with one member a row of TABLE, and its table as data. Params is the type
/// of p in the rows' ends.
#define COSIM_JOB(Job, TABLE, Params)                                           \
  struct Job {                                                                  \
    TABLE(COSIM_JOB_MEMBER)                                                     \
    enum Index : std::size_t { TABLE(COSIM_JOB_INDEX) index_end };              \
    static constexpr std::size_t size = index_end;                              \
    static constexpr auto members() {                                           \
      using Self = Job;                                                         \
      return std::array<::cosim::Word Self::*, size>{TABLE(COSIM_JOB_POINTER)}; \
    }                                                                           \
    static constexpr std::array<::cosim::JobField, size> fields(                \
        [[maybe_unused]] const Params& p) {                                     \
      return {TABLE(COSIM_JOB_FIELD)};                                          \
    }                                                                           \
  };                                                                            \
  static_assert(true, "so that a semicolon stands behind it")
