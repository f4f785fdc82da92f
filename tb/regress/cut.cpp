// Each work has a share of the shards in proportion to its minutes, at least one and no more than
// it has units; in it shard i begins at unit units * i / parts, so that no two differ by more than
// one unit.
#include "model/core/wide.h"
#include "tb/regress/run_folder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cosim::regress {
namespace {

double minutes_of(const std::vector<Size>& works) {
  return std::accumulate(works.begin(), works.end(), 0.0,
                         [](double sum, const Size& one) { return sum + one.minutes; });
}

}  // namespace

std::uint64_t usual_shards(const std::vector<Size>& works) {
  return static_cast<std::uint64_t>(
      std::clamp(std::ceil(minutes_of(works)), 1.0, static_cast<double>(most_shards)));
}

std::vector<Shard> cut(const std::vector<Size>& works, std::uint64_t shards) {
  const double all = minutes_of(works);
  std::vector<Shard> cuts;
  for (std::size_t w = 0; w < works.size(); ++w) {
    const std::uint64_t units = works[w].units;
    const auto share = static_cast<std::uint64_t>(
        std::llround(static_cast<double>(shards) * works[w].minutes / all));
    const std::uint64_t parts = std::clamp(share, std::uint64_t{1}, units);
    const auto begin = [&](std::uint64_t part) {
      return static_cast<std::uint64_t>(static_cast<Uint128>(units) * part / parts);
    };
    for (std::uint64_t i = 0; i < parts; ++i) cuts.push_back({w, begin(i), begin(i + 1)});
  }
  return cuts;
}

}  // namespace cosim::regress
