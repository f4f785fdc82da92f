// What the check of a design's jobs says of them, on the model or on one that is at fault.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "tb/sim/job_check.h"
#include "tb/util/random.h"

namespace cosim::test {

/// Drives the jobs on the model, as long as such jobs may take; change(outputs, clock) makes
/// another machine of it.
template <class Design, class Figures, class Change>
Checked judged(const typename Design::Params& p, const std::vector<JobOf<Design>>& jobs,
               Change change) {
  JobCheck<Design, Figures> check(p, jobs);
  HostOf<Design> host(p, jobs);
  auto s = reset_state_of<Design, Word>(p);
  typename Design::template Inputs<Word> in;
  Compared<Design> seen{};
  const std::uint64_t most = 5000 * jobs.size();
  for (std::uint64_t clock = 0; clock < most && host.next(in, seen.outputs); ++clock) {
    const auto step = Design::next(p, s, in);
    s = step.state;
    seen.outputs = step.outputs;
    change(seen.outputs, clock);
    check.clock(host.job(), seen);
  }
  return check.so_far();
}

/// So many jobs, as draw(params, seed, number) draws them.
template <class Params, class Draw>
auto drawn_jobs(Draw draw, const Params& p, std::uint64_t count) {
  std::vector<decltype(draw(p, std::uint64_t{1}, count))> all;
  for (std::uint64_t i = 0; i < count; ++i) all.push_back(draw(p, 1, i));
  return all;
}

/// The model's jobs pass, with these figures.
template <class Design, class Figures>
void expect_passes(const typename Design::Params& p, const std::vector<JobOf<Design>>& jobs,
                   std::uint64_t steps, double max_deviation) {
  const Checked found = judged<Design, Figures>(p, jobs, [](auto&, auto) {});
  EXPECT_EQ(found.error, "");
  EXPECT_EQ(found.jobs, jobs.size());
  EXPECT_GT(steps, 0U);
  EXPECT_EQ(found.count("steps"), steps);
  EXPECT_NEAR(found.number("max_deviation"), max_deviation, 1e-9);
}

/// Every fault on one clock is seen; change(outputs, how) makes it, and is false where there is
/// none.
template <class Design, class Figures, class Change>
void expect_faults_seen(const typename Design::Params& p, const std::vector<JobOf<Design>>& jobs,
                        Change change) {
  Random random(3);
  int faults = 0;
  for (int i = 0; i < 400; ++i) {
    const std::vector<JobOf<Design>> some{jobs[random.below(jobs.size())],
                                          jobs[random.below(jobs.size())]};
    const std::uint64_t at = random.below(40), how = random.next();
    bool is_changed = false;
    const Checked found = judged<Design, Figures>(p, some, [&](auto& outputs, std::uint64_t clock) {
      if (clock == at) is_changed = change(outputs, how);
    });
    EXPECT_EQ(found.error.empty(), !is_changed) << "fault " << i << " on clock " << at;
    faults += is_changed ? 1 : 0;
  }
  EXPECT_GT(faults, 50);
}

}  // namespace cosim::test
