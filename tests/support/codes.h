// Definitions of codes, tried out digit by digit.
#pragma once

#include "model/core/value.h"

namespace cosim::test {

/// The remainder in 0 .. m - 1.
inline Word modulo(Word v, Word m) { return (v % m + m) % m; }

/// A ones' complement code read digit by digit: a negative number is the complement of its size.
inline Word ones_complement_value(Word code, int width) {
  Word size = 0;
  const bool negative = (code >> (width - 1) & 1) != 0;
  for (int i = 0; i < width; ++i) {
    if (((code >> i & 1) != 0) != negative) size += Word{1} << i;
  }
  return negative ? -size : size;
}

}  // namespace cosim::test
