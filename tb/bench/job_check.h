// What is to come of declared jobs, seen by a design's Check on every clock that matched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "model/core/job.h"
#include "tb/bench/bench.h"

namespace cosim {

/// Counts the jobs that were driven to their end and, where the design has a Check, keeps what the
/// first wrong one gave.
template <class Design>
class JobCheck final : public Observer<Design> {
 public:
  using Job = typename Design::Job;
  static constexpr bool checks = requires { typename Design::Check; };

  JobCheck(const typename Design::Params& p, std::span<const Job> jobs) : p_(p), jobs_(jobs) {}

  void clock(std::size_t job, const Compared<Design>& seen) override {
    while (done_ < job) close();
    if constexpr (checks) open().clock(seen.outputs);
  }
  /// To be called when the last job has ended.
  void finish() {
    while (done_ < jobs_.size()) close();
  }
  std::uint64_t done() const { return done_; }
  /// "idle=3 byte=65: WHAT CAME", or empty.
  const std::string& error() const { return error_; }

 private:
  auto& open() {
    if (!check_) check_.emplace(typename Checks<Design>::Type{p_, jobs_[done_]});
    return *check_;
  }
  void close() {
    if constexpr (checks) {
      const std::string wrong = open().wrong();
      if (error_.empty() && !wrong.empty()) {
        error_ = JobHost<Design>::describe(p_, jobs_[done_]) + ": " + wrong;
      }
      check_.reset();
    }
    ++done_;
  }

  struct NoCheck {
    typename Design::Params p;
    Job job;
  };
  template <class D>
  struct Checks {
    using Type = NoCheck;
  };
  template <class D>
  requires requires { typename D::Check; }
  struct Checks<D> {
    using Type = typename D::Check;
  };

  typename Design::Params p_;
  std::span<const Job> jobs_;
  std::size_t done_ = 0;
  std::string error_;
  std::optional<typename Checks<Design>::Type> check_;
};

}  // namespace cosim
