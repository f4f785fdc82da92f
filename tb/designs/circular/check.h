// What the circular machine drew, against its oracle.
#pragma once

#include <cstdint>
#include <span>

#include "model/circular/host.h"
#include "tb/bench/bench.h"
#include "tb/sweep/checked.h"

namespace cosim::circular {

/// Compares each step with the oracle, the number of steps and the last point.
class Check final : public Observer<Design> {
 public:
  explicit Check(std::span<const Arc> arcs);
  void clock(std::size_t job, const Compared<Design>& seen) override;
  /// What was found so far, the present job left open.
  Checked so_far() const;
  /// Closes the last job.
  Checked finish();

 private:
  void open();
  void close();
  std::span<const Arc> arcs_;
  std::size_t job_ = 0;
  std::int64_t steps_ = 0;
  Point at_;
  Checked found_;
  std::uint64_t drawn_ = 0;  // elementary steps: clocks with a step
  double max_deviation_ = 0;
};

}  // namespace cosim::circular
