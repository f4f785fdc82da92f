// Every clock of a run, kept: for tests that look at single clocks.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "tests/support/explain.h"

namespace cosim::test {

template <class Design>
class Recorder final : public Observer<Design> {
 public:
  struct Clock {
    std::size_t job = 0;
    typename Design::template Registers<Word> registers;  ///< before the clock's edge
    typename Design::template Outputs<Word> outputs;
  };
  void clock(std::size_t job, const Compared<Design>& seen) override {
    clocks.push_back({job, seen.registers, seen.outputs});
  }
  std::vector<Clock> clocks;
};

/// Draws the jobs in lockstep and gives every clock; the test fails where RTL and model differ.
template <class Design>
std::vector<typename Recorder<Design>::Clock> draw(const Bench<Design>& bench,
                                                   std::span<const JobOf<Design>> jobs) {
  Recorder<Design> recorder;
  const Run run = bench.open(1)->draw(jobs, recorder);
  EXPECT_FALSE(run.mismatch) << explain(*run.mismatch);
  EXPECT_EQ(run.clocks, recorder.clocks.size());
  return recorder.clocks;
}

}  // namespace cosim::test
