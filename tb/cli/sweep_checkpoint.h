// The checkpoint of a command's sweeps, which run one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tb/sweep/checkpoint.h"
#include "tb/sweep/sweep.h"

namespace cosim::cli {

class SweepCheckpoint {
 public:
  /// `work`: the sweeps and what they depend on. An empty path keeps nothing. InputError if the
  /// file is no checkpoint of this work.
  SweepCheckpoint(const std::string& path, const std::string& work);

  /// Where sweep number i continues, and how it saves its state; must not outlive this. InputError
  /// if the file claims more finished cases than the sweep has.
  Resume resume(std::size_t i, std::uint64_t cases);
  /// Removes the file. To be called when the report is written.
  void done() { checkpoint_.done(); }

 private:
  [[noreturn]] void fail() const;

  std::string path_;
  Checkpoint checkpoint_;
  std::vector<Result> done_;  // a sweep each
};

}  // namespace cosim::cli
