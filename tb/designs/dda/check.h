// What the DDA drew, against its oracle.
#pragma once

#include <optional>
#include <span>

#include "model/dda/job.h"
#include "model/dda/oracle.h"
#include "tb/sweep/path_check.h"

namespace cosim::dda {

/// Compares the steps of each clock with the oracle, the codes and the last point.
class Check final : public PathCheck<Design> {
 public:
  Check(const Params& p, std::span<const Job> jobs) : PathCheck(jobs), p_(p) {}

 private:
  void open(const Job& job) override;
  void compare(const Job& job, const Compared<Design>& seen) override;
  void close(const Job& job) override;
  Params p_;
  std::optional<Track> track_;
  std::int64_t clocks_ = 0;
  bool over_ = false;
};

}  // namespace cosim::dda
