// The oracle that lanes have, on words, beside the check of one case at a time.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "model/core/design.h"
#include "tb/bench/bench.h"
#include "tb/nets/jobs.h"
#include "tb/support/random.h"
#include "tb/sweep/checked.h"

namespace cosim::test {

/// What both say of a list of jobs.
struct BothOracles {
  Checked check, lanes;
  bool is_wrong = false;  ///< by that of lanes
};

/// Draws the jobs on the model; change(outputs, clock) makes another machine of it.
template <class Lanes, class Check, class Change>
BothOracles both_oracles(const typename Lanes::Design::Params& p,
                         const std::vector<typename Lanes::Job>& jobs, Check check, Change change) {
  using Design = typename Lanes::Design;
  BothOracles both;
  auto s = cleared_of<Design, Word>();
  typename Lanes::Figures figures;
  std::uint64_t clock = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto task = Lanes::task_of(p, jobs[i]);
    const auto due = Lanes::due_of(p, jobs[i]);
    auto walked = Lanes::begun(p, jobs[i]);
    typename Lanes::template Driven<Word> driven{};
    for (bool over = false; !over; ++clock) {
      auto step = Design::next(p, s, Lanes::pins(p, task, driven));
      s = step.state;
      change(step.outputs, clock);
      const auto turn = Lanes::turned(p, task, driven, step.outputs);
      over = turn.over;
      const nets::JobIn<Lanes, Word> job{task, due, walked, driven};
      driven = turn.driven;
      const auto verdict = Lanes::walked(p, job, step.outputs, over);
      walked = verdict.walked;
      both.is_wrong = both.is_wrong || verdict.wrong;
      Compared<Design> seen{};
      seen.outputs = step.outputs;
      check.clock(i, seen);
    }
    figures.add(p, jobs[i], due, walked);
  }
  both.check = check.finish();
  both.lanes = figures.checked();
  return both;
}

template <class Lanes, class MakeCheck>
void expect_same_oracle(const typename Lanes::Design::Params& p,
                        const std::vector<typename Lanes::Job>& jobs, MakeCheck make) {
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
                       const std::vector<typename Lanes::Job>& jobs, MakeCheck make,
                       Change change) {
  Random random(3);
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    const std::vector<typename Lanes::Job> some{jobs[random.below(jobs.size())],
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
