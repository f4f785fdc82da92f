// Registers in ones' complement as the circular machine has them: a zero of their own, and sums
// with end-around carry.
#pragma once

#include "model/core/value.h"

namespace cosim::circular {

/// The ones' complement code of `width` bits of v, |v| < 2^(width-1); 0 gives -0, all ones.
template <class V>
constexpr V to_ones_complement_minus_zero(V v, int width) {
  return select(v > V(0), v, v + V(ones(width)));
}

/// Wraps a register of `width` bits that adds with end-around carry: v modulo 2^width - 1, brought
/// to |v| < 2^(width-1). For |v| < 2^width - 1, the most a sum of two such values can reach.
template <class V>
constexpr V wrap_end_around(V v, int width) {
  const Word largest = ones(width - 1);
  return select(v > V(largest), v - V(ones(width)), select(v < V(-largest), v + V(ones(width)), v));
}

}  // namespace cosim::circular
