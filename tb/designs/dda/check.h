// What the DDA drew, against its oracle.
#pragma once

#include <optional>
#include <span>

#include "model/dda/host.h"
#include "model/dda/oracle.h"
#include "tb/bench/bench.h"
#include "tb/sweep/checked.h"

namespace cosim::dda {

/// Compares the steps of each clock with the oracle, the codes and the last point.
class Check final : public Observer<Design> {
 public:
  Check(const Params& p, std::span<const Job> jobs);
  void clock(std::size_t job, const Compared<Design>& seen) override;
  /// What was found so far, the present job left open.
  Checked so_far() const;
  /// Closes the last job.
  Checked finish();

 private:
  void open();
  void close();
  Params p_;
  std::span<const Job> jobs_;
  std::size_t job_ = 0;
  std::optional<Track> track_;
  std::int64_t clocks_ = 0;
  bool over_ = false;
  Checked found_;
  std::uint64_t drawn_ = 0;  // elementary steps: clocks with a step
  double max_deviation_ = 0;
};

}  // namespace cosim::dda
