// The cases of a sweep as lanes take them: jobs, one after the other in each lane.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "model/core/design.h"
#include "model/core/value.h"
#include "tb/sim/checked.h"
#include "tb/sim/job_check.h"

namespace cosim {

/// Of one thread: a case in each lane.
class JobsAtWork {
 public:
  virtual ~JobsAtWork() = default;
  /// Lane number `lane` begins with case i.
  virtual void open(std::size_t lane, std::uint64_t i) = 0;
  /// Its next job, as the codes that it begins with; false at the end of its case.
  virtual bool next(std::size_t lane, std::span<Word> codes) = 0;
  /// It has come to the end of that job, and these are the codes of the figures.
  virtual void over(std::size_t lane, std::span<const Word> figures) = 0;
  /// Of all jobs so far.
  virtual Checked checked() const = 0;
};

/// Which bits of what is held of a job (nets/jobs.h) are what. The first says that it was over on
/// the last clock.
struct JobLayout {
  std::vector<int> begins;           ///< behind it, widths of the fields of task and checker
  std::size_t figures = 0;           ///< the first bit of the figures
  std::vector<int> figure_widths{};  ///< of their fields, the last ones of the checker
};

class LaneJobs {
 public:
  virtual ~LaneJobs() = default;
  virtual JobLayout layout() const = 0;
  /// How many cases of about the same length a lane should have one after the other: some where
  /// they are short, so that few lanes are without one at the end.
  virtual std::uint64_t cases_a_lane() const = 0;
  /// A job that is longer waits for ever.
  virtual std::uint64_t most_clocks() const = 0;
  virtual std::unique_ptr<JobsAtWork> begin(std::size_t lanes) const = 0;
};

/// The jobs of case i one after the other: sets the next one; false where there is none left.
template <class Job>
using JobsOf = std::function<std::function<bool(Job& job)>(std::uint64_t i)>;

/// All of them.
template <class Job>
std::vector<Job> all_of(const std::function<bool(Job& job)>& next) {
  std::vector<Job> all;
  for (Job job; next(job);) all.push_back(job);
  return all;
}
/// The other way round.
template <class Job>
auto one_by_one(std::vector<Job> all) {
  return [all = std::move(all), i = std::size_t{0}](Job& job) mutable {
    if (i == all.size()) return false;
    job = all[i++];
    return true;
  };
}

/// Figures as JobCheck has them.
template <class Design, class Figures = NoFigures<Design>>
class LaneJobsOf final : public LaneJobs {
  using Params = typename Design::Params;
  using Job = JobOf<Design>;
  using Task = TaskOf<Design, Word>;
  using Checker = CheckerOf<Design, Word>;

 public:
  LaneJobsOf(const Params& p, JobsOf<Job> jobs, std::uint64_t cases_a_lane)
      : p_(p), jobs_(std::move(jobs)), cases_a_lane_(cases_a_lane) {}
  std::uint64_t cases_a_lane() const override { return cases_a_lane_; }
  std::uint64_t most_clocks() const override { return most_clocks_of<Design>(); }
  JobLayout layout() const override {
    JobLayout all;
    all.figures = 1;
    for (const Field& field : Task::fields(p_)) {
      all.begins.push_back(field.width);
      all.figures += static_cast<std::size_t>(field.width);
    }
    const auto checker = Checker::fields(p_);
    std::size_t first = Figures::first;  // no constant: it may be 0
    for (std::size_t i = 0; i < checker.size(); ++i) {
      all.begins.push_back(checker[i].width);
      if (i < first) all.figures += static_cast<std::size_t>(checker[i].width);
      if (i >= first) all.figure_widths.push_back(checker[i].width);
    }
    return all;
  }
  std::unique_ptr<JobsAtWork> begin(std::size_t lanes) const override {
    return std::make_unique<AtWork>(*this, lanes);
  }

 private:
  class AtWork final : public JobsAtWork {
   public:
    AtWork(const LaneJobsOf& all, std::size_t lanes)
        : all_(all), held_(Checker::fields(all.p_)), lanes_(lanes) {}
    void open(std::size_t lane, std::uint64_t i) override { lanes_[lane].next = all_.jobs_(i); }
    bool next(std::size_t lane, std::span<Word> codes) override {
      Lane& at = lanes_[lane];
      if (!at.next(at.job)) return false;
      std::size_t i = 0;
      for (const Word word : to_words(task_for<Design>(all_.p_, at.job))) codes[i++] = word;
      for (const Word word : to_words(checker_for<Design>(all_.p_, at.job))) codes[i++] = word;
      return true;
    }
    void over(std::size_t lane, std::span<const Word> figures) override {
      Checker checker{};
      std::size_t first = Figures::first;
      for_each_cell<Checker>([&](auto cell, std::size_t i) {
        if (i >= first) cell(checker) = figures[i - first];
      });
      figures_.end_in_lane(all_.p_, lanes_[lane].job, held_.of(checker));
      ++jobs_;
    }
    Checked checked() const override {
      Checked all = figures_.checked();
      all.jobs = jobs_;
      return all;
    }

   private:
    struct Lane {
      std::function<bool(Job&)> next;
      Job job;
    };
    const LaneJobsOf& all_;
    Held<Checker> held_;
    std::vector<Lane> lanes_;
    Figures figures_;
    std::uint64_t jobs_ = 0;
  };

  Params p_;
  JobsOf<Job> jobs_;
  std::uint64_t cases_a_lane_;
};

}  // namespace cosim
