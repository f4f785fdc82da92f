// What the linear machine drew, against its oracle.
#pragma once

#include <cstdint>
#include <span>

#include "model/linear/job.h"
#include "tb/sweep/path_check.h"

namespace cosim::linear {

/// Compares each pair of words with the oracle, and the number of words.
class Check final : public PathCheck<Design> {
 public:
  Check(const Params& p, std::span<const Job> jobs) : PathCheck(jobs), p_(p) {}

 private:
  void open(const Job&) override { tick_ = 0; }
  void compare(const Job& job, const Compared<Design>& seen) override;
  void close(const Job& job) override;
  Params p_;
  std::int64_t tick_ = 0;
};

}  // namespace cosim::linear
