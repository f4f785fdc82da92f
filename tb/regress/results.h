// What came of the shards: lines of JSON, appended. A line that was cut off by a kill, a full disk
// or a lost node is seen, and its shard is run again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tb/regress/plan.h"

namespace cosim::regress {

/// What a host says of one shard.
struct Line {
  std::uint64_t shard = 0;
  std::string host;
  double seconds = 0;  ///< that it took
  Json result;         ///< of Work::run; null where it could not be run
  std::string error;   ///< why, one line
};

/// Appends the line to the file, which it makes where there is none, and waits until it is on the
/// disk. Behind a line that was cut off it begins a new one. `run`: RunFolder::identity, of which
/// with the line a hash is kept in it. InputError where it cannot be written.
void append(const std::filesystem::path& file, const std::string& run, const Line& line);

/// All that is in a run's folder of results.
struct Results {
  std::vector<std::optional<Line>> done;        ///< by shard; of one that ran twice the first
  std::map<std::uint64_t, std::string> errors;  ///< by shard, of those that are not done
  std::uint64_t twice = 0;                      ///< results of shards that were done already
  std::uint64_t torn = 0;                       ///< lines that were cut off or changed

  std::uint64_t finished() const;
  /// Done, and something in it does not hold.
  bool failed(std::uint64_t shard) const;
};

/// Reads all files of the folder, in the order of their names. Lines of shards that there are not,
/// and of another `run`, are torn ones. InputError where a file cannot be read.
Results read_results(const std::filesystem::path& folder, const std::string& run,
                     std::uint64_t shards);

}  // namespace cosim::regress
