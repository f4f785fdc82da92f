// The checkpoint of a command's sweeps, which run one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tb/sweep/checkpoint.h"
#include "tb/sweep/sweep.h"

namespace cosim::cli {

class SweepCheckpoint {
 public:
  /// `work`: the sweeps and what they depend on. An empty path keeps nothing. InputError where the
  /// file cannot be gone on from.
  SweepCheckpoint(const std::string& path, const std::string& work);

  /// What sweep number i, of so many cases, goes on from, and the way it keeps its state; must not
  /// outlive this. InputError where the file says that more cases are done.
  Resume resume(std::size_t i, std::uint64_t cases);
  /// To be called when the report is written: the file goes.
  void done() { checkpoint_.done(); }

 private:
  [[noreturn]] void fail() const;

  std::string path_;
  Checkpoint checkpoint_;
  std::vector<Result> done_;  // a sweep each
};

}  // namespace cosim::cli
