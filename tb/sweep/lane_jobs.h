// The cases of a sweep as lanes take them: jobs, one after the other in each lane.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "model/core/design.h"
#include "model/core/value.h"
#include "tb/nets/jobs.h"
#include "tb/sweep/checked.h"

namespace cosim {

/// Of one thread: a case in each lane.
class JobsAtWork {
 public:
  virtual ~JobsAtWork() = default;
  /// Lane number `lane` begins with case i.
  virtual void open(std::size_t lane, std::uint64_t i) = 0;
  /// Its next job, as the codes that it begins with; false at the end of its case.
  virtual bool next(std::size_t lane, std::span<Word> codes) = 0;
  /// It has drawn that job, and these are the codes of the figures.
  virtual void over(std::size_t lane, std::span<const Word> figures) = 0;
  /// Of all jobs so far.
  virtual Checked checked() const = 0;
};

class LaneJobs {
 public:
  virtual ~LaneJobs() = default;
  virtual nets::Draw draw() const = 0;
  virtual nets::JobLayout layout() const = 0;
  /// How many cases of about the same length a lane should have one after the other: some where
  /// they are short, so that few lanes are without one at the end.
  virtual std::uint64_t cases_a_lane() const = 0;
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

/// Jobs, see nets/jobs.h, has besides: Figures figures_of(p, job, due, walked) of a job that was
/// drawn. Figures are added up by add() and give checked(), which counts no jobs.
template <class Jobs>
class LaneJobsOf final : public LaneJobs {
  using Params = typename Jobs::Design::Params;
  using Job = typename HostOf<typename Jobs::Design>::Job;
  using Walk = typename Jobs::template Walk<Word>;

 public:
  LaneJobsOf(const Params& p, JobsOf<Job> jobs, std::uint64_t cases_a_lane)
      : p_(p), jobs_(std::move(jobs)), cases_a_lane_(cases_a_lane) {}
  std::uint64_t cases_a_lane() const override { return cases_a_lane_; }
  nets::Draw draw() const override { return nets::draw_of_jobs<Jobs>(p_); }
  nets::JobLayout layout() const override { return nets::job_layout_of<Jobs>(p_); }
  std::unique_ptr<JobsAtWork> begin(std::size_t lanes) const override {
    return std::make_unique<AtWork>(*this, lanes);
  }

 private:
  class AtWork final : public JobsAtWork {
   public:
    AtWork(const LaneJobsOf& all, std::size_t lanes) : all_(all), lanes_(lanes) {}
    void open(std::size_t lane, std::uint64_t i) override { lanes_[lane].next = all_.jobs_(i); }
    bool next(std::size_t lane, std::span<Word> codes) override {
      Lane& at = lanes_[lane];
      if (!at.next(at.job)) return false;
      std::size_t i = 0;
      for (const Word word : to_words(task_of(all_.p_, at.job))) codes[i++] = word;
      at.due = due_of(all_.p_, at.job);
      for (const Word word : to_words(at.due)) codes[i++] = word;
      for (const Word word : to_words(begun(all_.p_, at.job))) codes[i++] = word;
      return true;
    }
    void over(std::size_t lane, std::span<const Word> figures) override {
      using Walked = decltype(Walk::walked);
      Walked walked{};
      const auto fields = Walked::fields(all_.p_);
      std::size_t first = Jobs::figures;  // no constant: it may be 0
      for_each_cell<Walked>([&](auto cell, std::size_t i) {
        if (i >= first) cell(walked) = units_of(fields[i], figures[i - first]);
      });
      figures_.add(Jobs::figures_of(all_.p_, lanes_[lane].job, lanes_[lane].due, walked));
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
      decltype(Walk::due) due;
    };
    const LaneJobsOf& all_;
    std::vector<Lane> lanes_;
    typename Jobs::Figures figures_;
    std::uint64_t jobs_ = 0;
  };

  Params p_;
  JobsOf<Job> jobs_;
  std::uint64_t cases_a_lane_;
};

}  // namespace cosim
