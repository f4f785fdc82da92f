// Bits in reverse order, by the operations of a value type.
#pragma once

#include "model/core/value.h"

namespace cosim::linear {

/// v of 32 bits with neighbouring groups of bits exchanged; `lower` has ones in every other group.
template <class V>
constexpr V exchanged(V v, int bits, Word lower) {
  return shift_left(v & V(lower), bits) + (shift_right(v, bits) & V(lower));
}

/// The bits of v in reverse order: bit 0 becomes bit `width` - 1. 1 <= width <= 32, v < 2^width.
template <class V>
constexpr V reversed(V v, int width) {
  v = exchanged(v, 16, 0xffff);
  v = exchanged(v, 8, 0xff'00ff);
  v = exchanged(v, 4, 0xf0f'0f0f);
  v = exchanged(v, 2, 0x3333'3333);
  v = exchanged(v, 1, 0x5555'5555);
  return shift_right(v, 32 - width);
}

}  // namespace cosim::linear
