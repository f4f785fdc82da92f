// What the linear machine drew, against its oracle.
#pragma once

#include <cstdint>
#include <span>

#include "model/linear/host.h"
#include "tb/bench/bench.h"
#include "tb/sweep/checked.h"

namespace cosim::linear {

/// Compares each pair of words with the oracle, and the number of words.
class Check final : public Observer<Design> {
 public:
  Check(const Params& p, std::span<const Job> jobs) : p_(p), jobs_(jobs) {}
  void clock(std::size_t job, const Compared<Design>& seen) override;
  /// What was found so far, the present job left open.
  Checked so_far() const;
  /// Closes the last job.
  Checked finish();

 private:
  void close();
  Params p_;
  std::span<const Job> jobs_;
  std::size_t job_ = 0;
  std::int64_t tick_ = 0;
  Checked found_;
  std::uint64_t drawn_ = 0;  // elementary steps: positions of the major axis
  double max_deviation_ = 0;
};

}  // namespace cosim::linear
