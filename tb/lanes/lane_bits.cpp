// What is put visits the bits that are 1, of 64 at a time: of most jobs they are few.
#include "tb/lanes/lane_bits.h"

#include <bit>
#include <utility>

#include "model/core/value.h"

namespace cosim::lanes {

Packed::Packed(std::vector<int> widths) : widths_(std::move(widths)) {
  for (const int width : widths_) bits_ += static_cast<std::size_t>(width);
}

void Packed::pack(std::span<const std::int64_t> codes, std::uint64_t* words) const {
  std::uint64_t word = 0;
  int at = 0;
  for (std::size_t i = 0; i < widths_.size(); ++i) {
    const int width = widths_[i];
    if (width == 0) continue;
    const auto code = static_cast<std::uint64_t>(low_bits(codes[i], width));
    word |= code << at;
    at += width;
    if (at < 64) continue;
    *words++ = word;
    at -= 64;
    // Of the code that filled the word the bits behind it; a shift by 64 would be none.
    word = at == 0 ? 0 : code >> (width - at);
  }
  if (at != 0) *words = word;
}

void Packed::put(const std::uint64_t* packed, std::uint64_t* planes, std::size_t words,
                 std::size_t lane) const {
  planes += lane / 64;
  const std::uint64_t own = std::uint64_t{1} << (lane % 64);
  for (std::size_t first = 0; first < bits_; first += 64, planes += 64 * words) {
    for (std::uint64_t left = *packed++; left != 0; left &= left - 1) {
      planes[static_cast<std::size_t>(std::countr_zero(left)) * words] |= own;
    }
  }
}

void Packed::get(const std::uint64_t* planes, std::size_t words, std::size_t lane,
                 std::span<std::int64_t> codes) const {
  planes += lane / 64;
  for (std::size_t i = 0; i < widths_.size(); ++i) {
    std::uint64_t code = 0;
    for (int b = 0; b < widths_[i]; ++b, planes += words) code |= (*planes >> (lane % 64) & 1) << b;
    codes[i] = static_cast<std::int64_t>(code);
  }
}

}  // namespace cosim::lanes
