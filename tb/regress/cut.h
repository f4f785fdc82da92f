// Works cut into shards, by numbers alone.
#pragma once

#include <cstdint>
#include <vector>

namespace cosim::regress {

/// A work as far as it is cut.
struct Size {
  std::uint64_t units = 0;  ///< >= 1
  double minutes = 0;       ///< that it is thought to take, > 0
};

/// Units first to last - 1 of a work.
struct Shard {
  std::size_t work = 0;
  std::uint64_t first = 0, last = 0;
};

/// The most shards of a run.
inline constexpr std::uint64_t most_shards = 1'000'000;

/// As many as give each a minute, at most most_shards.
std::uint64_t usual_shards(const std::vector<Size>& works);

/// About `shards` shards in the order of the works and of their units, each work in equal parts: by
/// the time it is thought to take, at least one each, and none without a unit.
std::vector<Shard> cut(const std::vector<Size>& works, std::uint64_t shards);

}  // namespace cosim::regress
