// An array of values: the words of a memory, the registers of a register file, or a number of more
// than 64 bits as words of 64.
#pragma once

#include <array>
#include <cstddef>

#include "model/core/value.h"

namespace cosim {

/// N values, all 0 unless they are given: Array<V, 4> a{V(1), V(2)} has two and two zeros.
template <class V, int N>
struct Array {
  static_assert(N >= 1);
  using Value = V;
  static constexpr int size = N;

  std::array<V, static_cast<std::size_t>(N)> elements{};

  /// Element i, 0 <= i < N: a number that is known when the model is compiled or looped over. An
  /// index that is a value of the design, V, is for read() and write().
  constexpr V& operator[](int i) { return elements[static_cast<std::size_t>(i)]; }
  constexpr const V& operator[](int i) const { return elements[static_cast<std::size_t>(i)]; }
  constexpr auto begin() { return elements.begin(); }
  constexpr auto begin() const { return elements.begin(); }
  constexpr auto end() { return elements.end(); }
  constexpr auto end() const { return elements.end(); }

  /// a where c holds, else b, element by element.
  friend constexpr Array select(Condition<V> c, const Array& a, const Array& b) {
    Array r;
    for (int i = 0; i < N; ++i) r[i] = select(c, a[i], b[i]);
    return r;
  }
};

}  // namespace cosim
