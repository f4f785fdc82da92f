// What the circular machine drew, against its oracle.
#pragma once

#include <cstdint>

#include "model/circular/job.h"
#include "tb/sweep/path_check.h"

namespace cosim::circular {

/// Compares each step with the oracle, the number of steps and the last point.
class Check final : public PathCheck<Design> {
 public:
  using PathCheck::PathCheck;

 private:
  void open(const Arc& arc) override;
  void compare(const Arc& arc, const Compared<Design>& seen) override;
  void close(const Arc& arc) override;
  std::int64_t steps_ = 0;
  Point at_;
};

}  // namespace cosim::circular
