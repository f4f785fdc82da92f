// What a regression says while it runs, and before.
#pragma once

#include <chrono>
#include <string>

#include "tb/regress/local.h"

namespace cosim::cli {

/// What would run, how it is cut and what it is thought to take, lines.
std::string dry_run_text(const regress::Plan& plan, const std::vector<regress::Known>& works,
                         std::uint64_t shards, unsigned jobs);

/// How far a run is: one line that redraws itself on a terminal, elsewhere a line a minute and one
/// for each shard that fails.
class RegressProgress {
 public:
  RegressProgress();
  void show(const regress::Tally& tally);
  /// Takes the line away.
  void clear();

 private:
  using Time = std::chrono::steady_clock;
  std::string text(const regress::Tally& tally) const;

  bool terminal_, drawn_ = false;
  Time::time_point began_ = Time::now(), due_ = began_ + std::chrono::minutes(1);
  double minutes_before_ = -1;  // done when it began
  std::uint64_t failed_ = 0;
};

/// A line each for the reasons why shards could not be run, those of equal ones together.
std::vector<std::string> lines_of(const regress::Errors& errors);

}  // namespace cosim::cli
