// The check of a design's jobs, on words, beside an oracle that compares one job at a time.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "model/core/design.h"
#include "tb/bench/bench.h"
#include "tb/bench/checked.h"
#include "tb/bench/job_check.h"
#include "tb/support/random.h"

namespace cosim::test {

/// What both say of a list of jobs.
struct BothOracles {
  Checked oracle, check;
};

/// Drives the jobs on the model; change(outputs, clock) makes another machine of it.
template <class Design, class Figures, class Oracle, class Change>
BothOracles both_oracles(const typename Design::Params& p, const std::vector<JobOf<Design>>& jobs,
                         Oracle oracle, Change change) {
  JobCheck<Design, Figures> check(p, jobs);
  HostOf<Design> host(p, jobs);
  auto s = reset_state_of<Design, Word>();
  typename Design::template Inputs<Word> in;
  Compared<Design> seen{};
  for (std::uint64_t clock = 0; host.next(in, seen.outputs); ++clock) {
    const auto step = Design::next(p, s, in);
    s = step.state;
    seen.outputs = step.outputs;
    change(seen.outputs, clock);
    check.clock(host.job(), seen);
    oracle.clock(host.job(), seen);
  }
  return {oracle.finish(), check.finish()};
}

template <class Design, class Figures, class MakeOracle>
void expect_same_oracle(const typename Design::Params& p, const std::vector<JobOf<Design>>& jobs,
                        MakeOracle make) {
  const auto both =
      both_oracles<Design, Figures>(p, jobs, make(std::span(jobs)), [](auto&, auto) {});
  EXPECT_EQ(both.oracle.error, "");
  EXPECT_EQ(both.check.error, "");
  EXPECT_EQ(both.check.jobs, jobs.size());
  EXPECT_GT(both.check.count("steps"), 0U);
  EXPECT_EQ(both.check.count("steps"), both.oracle.count("steps"));
  EXPECT_DOUBLE_EQ(both.check.number("max_deviation"), both.oracle.number("max_deviation"));
}

/// A fault on one clock, which change(outputs, how) makes, is seen by both or by none.
template <class Design, class Figures, class MakeOracle, class Change>
void expect_same_finds(const typename Design::Params& p, const std::vector<JobOf<Design>>& jobs,
                       MakeOracle make, Change change) {
  Random random(3);
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    const std::vector<JobOf<Design>> some{jobs[random.below(jobs.size())],
                                          jobs[random.below(jobs.size())]};
    const std::uint64_t at = random.below(40), how = random.next();
    const auto both = both_oracles<Design, Figures>(p, some, make(std::span(some)),
                                                    [&](auto& outputs, std::uint64_t clock) {
                                                      if (clock == at) change(outputs, how);
                                                    });
    ASSERT_EQ(both.check.error.empty(), both.oracle.error.empty())
        << "fault " << i << " on clock " << at << ": " << both.check.error << "; "
        << both.oracle.error;
    seen += both.check.error.empty() ? 0 : 1;
  }
  EXPECT_GT(seen, 100);
}

}  // namespace cosim::test
