// Arrays at an index that is a value of the design: a memory's word, a register of a register file.
#pragma once

#include <concepts>

#include "model/core/array.h"
#include "model/core/value.h"

namespace cosim {

namespace detail {

// Element first + n, n the lower `bits` bits of the index. Where the array has no such element the
// result is some other one: the caller must not use it.
template <class E, int N, class V>
constexpr E element(const Array<E, N>& array, const V& index, int first, int bits) {
  if (bits == 0) return array[first];
  const int middle = first + (1 << (bits - 1));
  const E low = element(array, index, first, bits - 1);
  return middle < N ? select(bit(index, bits - 1), element(array, index, middle, bits - 1), low)
                    : low;
}

constexpr int bits_for(int count) {
  int bits = 0;
  while ((1 << bits) < count) ++bits;
  return bits;
}

template <class V>
constexpr Condition<V> is_index(const V& index, int size) {
  return !((index < V(0)) | (index > V(size - 1)));
}

}  // namespace detail

/// The element at `index`; 0 (E{}) where the index is outside the array.
template <class E, int N, class V>
constexpr E read(const Array<E, N>& array, const V& index) {
  const auto is_there = detail::is_index(index, N);
  if constexpr (std::same_as<V, Word>) {
    return is_there ? array[static_cast<int>(index)] : E{};
  } else {
    return select(is_there, detail::element(array, index, 0, detail::bits_for(N)), E{});
  }
}

/// The array with `value` at `index`; unchanged where the index is outside the array.
template <class E, int N, class V>
constexpr Array<E, N> write(Array<E, N> array, const V& index, const E& value) {
  if constexpr (std::same_as<V, Word>) {
    if (detail::is_index(index, N)) array[static_cast<int>(index)] = value;
  } else {
    for (int i = 0; i < N; ++i) array[i] = select(index == V(i), value, array[i]);
  }
  return array;
}

/// The same where c holds; else the array unchanged.
template <class E, int N, class V>
constexpr Array<E, N> write_where(Condition<V> c, const Array<E, N>& array, const V& index,
                                  const E& value) {
  return write(array, index, select(c, value, read(array, index)));
}

}  // namespace cosim
