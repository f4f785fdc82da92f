// Bit strings: parts of them, and what is made of parts. Of the operations in value.h alone, so for
// every value type. A width is in bits; a bit string of 64 bits is held as a Word's bit pattern.
#pragma once

#include "model/core/value.h"

namespace cosim {

/// Bits high .. low of v, as Verilog's v[high:low]. 0 <= low <= high <= 63.
template <class V>
constexpr V slice(V v, int high, int low) {
  return low_bits(shift_right(v, low), high - low + 1);
}

/// `high` above the lower `width_of_low` bits of `low`, as Verilog's {high, low}.
/// 1 <= width_of_low <= 63; what leaves 64 bits is lost.
template <class High, class Low>
constexpr auto join(High high, Low low, int width_of_low) {
  const auto lower = low_bits(low, width_of_low);
  return shift_left(decltype(lower)(high), width_of_low) + lower;
}

/// The lower `width` bits of v, each the other way. 1 <= width <= 64.
template <class V>
constexpr V invert(V v, int width) {
  return low_bits(v, width) ^ V(ones(width));
}

/// Whether all of the lower `width` bits are set, 1 <= width <= 64. For any of them: is_set().
template <class V>
constexpr Condition<V> all_set(V v, int width) {
  return low_bits(v, width) == V(ones(width));
}

/// Whether the number of bits set is odd, of the lower `width`, 1 <= width <= 64.
template <class V>
constexpr Condition<V> parity(V v, int width) {
  V folded = low_bits(v, width);
  for (int half = 32; half > 0; half /= 2) {
    if (half < width) folded = folded ^ shift_right(folded, half);
  }
  return bit(folded, 0);
}

/// The lower `width` bits of v, the highest n of them moved below the others.
/// 0 <= n < width <= 64.
template <class V>
constexpr V rotate_left(V v, int n, int width) {
  if (n == 0) return low_bits(v, width);
  return join(low_bits(v, width - n), slice(v, width - 1, width - n), n);
}

/// Whether a is less than b as numbers without a sign, which < does not say of codes of 64 bits.
template <class V>
constexpr Condition<V> below(V a, V b) {
  const V sign(shift_left(1, 63));
  return (a ^ sign) < (b ^ sign);
}

}  // namespace cosim
