// The checkpoint of a command's sweeps, which run one after the other.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/sim/bench.h"
#include "tb/sim/checkpoint.h"
#include "tb/sim/sweep.h"

namespace cosim::cli {

class SweepCheckpoint {
 public:
  /// `work`: the sweeps and what they depend on. An empty path keeps nothing. InputError if the
  /// file is no checkpoint of this work.
  SweepCheckpoint(const std::string& path, const std::string& work);

  /// Where the next sweep, of so many cases on this bench, continues, and how it saves its state;
  /// must not outlive this. InputError where the file has no such state of it.
  Resume resume(const AnyBench& bench, std::uint64_t cases);
  /// Removes the file. To be called when the report is written.
  void done() { checkpoint_.done(); }

 private:
  Checkpoint checkpoint_;
  std::vector<JsonAt> kept_;  // of the file, a sweep each
  std::vector<Result> done_;  // of those that were begun
};

}  // namespace cosim::cli
