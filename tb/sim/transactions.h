// How much of one stream a run has seen. A run that compares nothing finds nothing, so that these
// figures stand beside each verdict.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cosim {

struct StreamName {
  std::string name;
  bool goes_in = true;
};

struct Transactions {
  std::uint64_t moved = 0;     ///< went in, or came out
  std::uint64_t compared = 0;  ///< of those that came out

  bool operator==(const Transactions&) const = default;
};

/// Adds two runs, stream by stream; `sum` may be empty.
inline void add(std::vector<Transactions>& sum, const std::vector<Transactions>& one) {
  if (sum.size() < one.size()) sum.resize(one.size());
  for (std::size_t s = 0; s < one.size(); ++s) {
    sum[s].moved += one[s].moved;
    sum[s].compared += one[s].compared;
  }
}

}  // namespace cosim
