// The oracle that lanes have, on words, beside the check of one case at a time.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "model/core/design.h"
#include "tb/bench/bench.h"
#include "tb/support/random.h"
#include "tb/sweep/checked.h"

namespace cosim::test {

template <class Lanes>
using JobOf = typename HostOf<typename Lanes::Design>::Job;

/// What both say of a list of jobs.
struct BothOracles {
  Checked check, lanes;
  bool is_wrong = false;  ///< by that of lanes
};

/// Draws the jobs on the model; change(outputs, clock) makes another machine of it.
template <class Lanes, class Check, class Change>
BothOracles both_oracles(const typename Lanes::Design::Params& p,
                         const std::vector<JobOf<Lanes>>& jobs, Check check, Change change) {
  using Design = typename Lanes::Design;
  BothOracles both;
  auto s = reset_state_of<Design, Word>();
  typename Lanes::Figures figures;
  std::uint64_t clock = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    typename Lanes::template Walk<Word> walk{
        task_of(p, jobs[i]), due_of(p, jobs[i]), begun(p, jobs[i]), {}};
    for (bool over = false; !over; ++clock) {
      auto step = Design::next(p, s, pins(p, walk.task, walk.driven));
      s = step.state;
      change(step.outputs, clock);
      const auto turn = turned(p, walk.driven, step.outputs);
      over = turn.over;
      const auto verdict = walked(p, walk, step.outputs, over);
      walk.driven = turn.driven;
      walk.walked = verdict.walked;
      both.is_wrong = both.is_wrong || verdict.wrong;
      Compared<Design> seen{};
      seen.outputs = step.outputs;
      check.clock(i, seen);
    }
    figures.add(Lanes::figures_of(p, jobs[i], walk.due, walk.walked));
  }
  both.check = check.finish();
  both.lanes = figures.checked();
  return both;
}

template <class Lanes, class MakeCheck>
void expect_same_oracle(const typename Lanes::Design::Params& p,
                        const std::vector<JobOf<Lanes>>& jobs, MakeCheck make) {
  const auto both = both_oracles<Lanes>(p, jobs, make(std::span(jobs)), [](auto&, auto) {});
  EXPECT_EQ(both.check.error, "");
  EXPECT_FALSE(both.is_wrong);
  EXPECT_GT(both.lanes.count("steps"), 0U);
  EXPECT_EQ(both.lanes.count("steps"), both.check.count("steps"));
  EXPECT_DOUBLE_EQ(both.lanes.number("max_deviation"), both.check.number("max_deviation"));
}

/// A fault on one clock, which change(outputs, how) makes, is seen by both or by none.
template <class Lanes, class MakeCheck, class Change>
void expect_same_finds(const typename Lanes::Design::Params& p,
                       const std::vector<JobOf<Lanes>>& jobs, MakeCheck make, Change change) {
  Random random(3);
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    const std::vector<JobOf<Lanes>> some{jobs[random.below(jobs.size())],
                                         jobs[random.below(jobs.size())]};
    const std::uint64_t at = random.below(40), how = random.next();
    const auto both = both_oracles<Lanes>(p, some, make(std::span(some)),
                                          [&](auto& outputs, std::uint64_t clock) {
                                            if (clock == at) change(outputs, how);
                                          });
    ASSERT_EQ(both.is_wrong, !both.check.error.empty())
        << "fault " << i << " on clock " << at << ": " << both.check.error;
    seen += both.is_wrong ? 1 : 0;
  }
  EXPECT_GT(seen, 100);
}

}  // namespace cosim::test
