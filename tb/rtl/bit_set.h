// The bits of a net, any number of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cosim::rtl {

class BitSet {
 public:
  BitSet() = default;
  /// Those from `low` on.
  BitSet(std::size_t low, std::size_t count) : words_((low + count + 63) / 64) {
    for (std::size_t i = low; i < low + count; ++i) words_[i / 64] |= std::uint64_t{1} << i % 64;
  }
  bool has(std::size_t bit) const {
    return bit / 64 < words_.size() && (words_[bit / 64] >> bit % 64 & 1) != 0;
  }
  bool is_empty() const {
    return std::ranges::all_of(words_, [](std::uint64_t word) { return word == 0; });
  }
  BitSet& operator|=(const BitSet& other) {
    words_.resize(std::max(words_.size(), other.words_.size()));
    for (std::size_t i = 0; i < other.words_.size(); ++i) words_[i] |= other.words_[i];
    return *this;
  }
  BitSet& operator&=(const BitSet& other) {
    words_.resize(std::min(words_.size(), other.words_.size()));
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
  }
  BitSet& operator-=(const BitSet& other) {
    const std::size_t n = std::min(words_.size(), other.words_.size());
    for (std::size_t i = 0; i < n; ++i) words_[i] &= ~other.words_[i];
    return *this;
  }
  /// The high and the low bit of each range, the highest one first.
  std::vector<std::pair<int, int>> ranges() const {
    std::vector<std::pair<int, int>> all;
    for (std::size_t end = 64 * words_.size(); end > 0; --end) {
      if (!has(end - 1)) continue;
      std::size_t low = end - 1;
      while (low > 0 && has(low - 1)) --low;
      all.emplace_back(end - 1, low);
      end = low + 1;
    }
    return all;
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace cosim::rtl
