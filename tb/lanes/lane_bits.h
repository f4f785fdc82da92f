// The bits of one lane in planes of so many words: bit i in plane number i.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cosim::lanes {

/// Codes of these widths, each 0 to 64, one behind the other, lowest bit first, as words of 64
/// bits.
class Packed {
 public:
  explicit Packed(std::vector<int> widths);
  /// How many words they are.
  std::size_t words() const { return (bits_ + 63) / 64; }
  /// Of each code its lowest bits.
  void pack(std::span<const std::int64_t> codes, std::uint64_t* words) const;

  /// Sets the bits that are 1 in `packed`; all are 0 before.
  void put(const std::uint64_t* packed, std::uint64_t* planes, std::size_t words,
           std::size_t lane) const;
  /// The codes that a lane holds.
  void get(const std::uint64_t* planes, std::size_t words, std::size_t lane,
           std::span<std::int64_t> codes) const;

 private:
  std::vector<int> widths_;
  std::size_t bits_ = 0;
};

}  // namespace cosim::lanes
