// What the DDA drew, against its oracle.
#pragma once

#include <optional>
#include <span>

#include "model/dda/host.h"
#include "model/dda/oracle.h"
#include "tb/check.h"

namespace cosim {

/// Compares the steps of each clock with the oracle, the codes and the last point.
class DdaCheck final : public Observer<dda::Design> {
 public:
  DdaCheck(const dda::Params& p, std::span<const dda::Job> jobs);
  void clock(std::size_t job, const Compared<dda::Design>& seen) override;
  /// What was found so far, the present job left open.
  const Checked& so_far() const { return found_; }
  /// Closes the last job.
  Checked finish();

 private:
  void open();
  void close();
  dda::Params p_;
  std::span<const dda::Job> jobs_;
  std::size_t job_ = 0;
  std::optional<dda::Track> track_;
  std::int64_t clocks_ = 0;
  bool over_ = false;
  Checked found_;
};

}  // namespace cosim
