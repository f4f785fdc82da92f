// The operations on a value of a record, for machine integers; on bits of gates they are those of
// nets::Number. Code that is to run on both is a template over the value type V. V offers +, - and
// * (with V), &, | and ^ bit by bit, comparisons, V(int), and the functions below; a comparison
// gives a Condition<V>, which offers !, &, | and ^. A condition may stand where a value may, as 1
// or 0. A sum, difference or product must fit into a Word; where it may not, as those of codes of
// 64 bits, there are add(), subtract() and multiply().
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace cosim {

/// The machine integer that models run on. Codes of up to 64 bits are held as its bit pattern.
using Word = std::int64_t;

/// What comparing two values gives: bool for machine integers, a symbol for symbols.
template <class V>
using Condition = decltype(std::declval<V>() < std::declval<V>());

/// The lower `width` bits of v as a number >= 0 (for width 64: the bit pattern). 1 <= width <= 64.
constexpr Word low_bits(Word v, int width) {
  return static_cast<Word>(static_cast<std::uint64_t>(v) & (~std::uint64_t{0} >> (64 - width)));
}

/// Bit i of v, 0 <= i <= 63, two's complement for v < 0.
constexpr bool bit(Word v, int i) { return ((v >> i) & 1) != 0; }

/// v * 2^n, 0 <= n <= 63, modulo 2^64.
constexpr Word shift_left(Word v, int n) {
  return static_cast<Word>(static_cast<std::uint64_t>(v) << n);
}

/// floor(v / 2^n), 0 <= n <= 63.
constexpr Word shift_right(Word v, int n) { return v >> n; }

/// The same by a value. It is a number without a sign, so that one of more than 63, or a negative
/// one, shifts every bit out: what is left is 0, or -1 of a negative number to the right.
constexpr Word shift_left(Word v, Word n) {
  return (n & ~Word{63}) == 0 ? shift_left(v, int(n)) : 0;
}
constexpr Word shift_right(Word v, Word n) {
  return shift_right(v, (n & ~Word{63}) == 0 ? int(n) : 63);
}

/// a + b, a - b and a * b modulo 2^64, as a bit pattern.
constexpr Word add(Word a, Word b) {
  return static_cast<Word>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}
constexpr Word subtract(Word a, Word b) {
  return static_cast<Word>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}
constexpr Word multiply(Word a, Word b) {
  return static_cast<Word>(static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b));
}

/// a where c holds, else b.
constexpr Word select(bool c, Word a, Word b) { return c ? a : b; }

/// The same of conditions.
template <class C>
requires std::same_as<decltype(!std::declval<C>()), C>
constexpr C select(C c, C a, C b) { return (c & a) | (!c & b); }

/// then() where c holds, else otherwise(): only a symbolic condition runs both. For whole records
/// and for results too costly to work out on every clock.
template <class Then, class Otherwise>
constexpr auto if_else(bool c, Then then, Otherwise otherwise) {
  return c ? then() : otherwise();
}
template <class C, class Then, class Otherwise>
requires(!std::same_as<C, bool>) constexpr auto if_else(C c, Then then, Otherwise otherwise) {
  return select(c, then(), otherwise());
}

// The rest is built from these.

/// A one-bit field as a condition; of a wider value, whether any bit of it is set.
template <class V>
constexpr Condition<V> is_set(V flag) {
  return !(flag == V(0));
}

/// 1 where c holds, else 0.
template <class V>
constexpr V flag(Condition<V> c) {
  return select(c, V(1), V(0));
}

/// 2^n - 1, 1 <= n <= 64; as a bit pattern for n = 64.
constexpr Word ones(int n) { return low_bits(-1, n); }

/// The value of a two's complement code of `width` bits.
constexpr Word from_twos_complement(Word code, int width) {
  return shift_right(shift_left(code, 64 - width), 64 - width);
}

/// The value of a ones' complement code of `width` bits; both zeros give 0.
template <class V>
constexpr V from_ones_complement(V code, int width) {
  return select(bit(code, width - 1), code - V(ones(width)), code);
}

/// The ones' complement code of `width` bits of v, |v| < 2^(width-1); 0 gives +0, all zeros.
template <class V>
constexpr V to_ones_complement(V v, int width) {
  return select(v < V(0), v + V(ones(width)), v);
}

/// Wraps a counter of `width` bits: v modulo 2^width.
template <class V>
constexpr V wrap(V v, int width) {
  return low_bits(v, width);
}

/// A value that is a symbol: what machine integers have besides, and what symbols cannot have,
/// which is said in words where a model uses it. Its conditions are a SymbolicCondition.
struct SymbolicCondition {
  template <std::same_as<bool> B>
  explicit operator B() const {
    static_assert(!std::same_as<B, bool>,
                  "a model asks what is only known of numbers, by if, ?:, && or ||: write "
                  "select(condition, a, b), & and |, or write UNPROVED in cosim_add_design()");
    return false;
  }
};
struct Symbolic : SymbolicCondition {};
template <class V>
concept IsSymbolic = std::derived_from<V, Symbolic>;

// clang-format off
template <IsSymbolic V, class W> V& operator+=(V& a, const W& b) { return a = a + b; }
template <IsSymbolic V, class W> V& operator-=(V& a, const W& b) { return a = a - b; }
template <IsSymbolic V, class W> V& operator&=(V& a, const W& b) { return a = a & b; }
template <IsSymbolic V, class W> V& operator|=(V& a, const W& b) { return a = a | b; }
template <IsSymbolic V, class W> V& operator^=(V& a, const W& b) { return a = a ^ b; }
template <IsSymbolic V> V operator-(const V& a) { return V(0) - a; }
template <IsSymbolic V> V operator~(const V& a) { return V(-1) ^ a; }
template <IsSymbolic V, class W> auto operator!=(const V& a, const W& b) { return !(a == b); }
template <IsSymbolic V, class W> auto operator<=(const V& a, const W& b) { return !(a > b); }
template <IsSymbolic V, class W> auto operator>=(const V& a, const W& b) { return !(a < b); }
template <IsSymbolic V> auto operator!(const V& a) { return a == V(0); }
template <IsSymbolic V>
V select(const V& c, const std::type_identity_t<V>& a, const std::type_identity_t<V>& b) {
  return select(is_set(c), a, b);
}
#define COSIM_NO_MODEL_HAS(OPERATOR, IN_ITS_PLACE)                                        \
  template <IsSymbolic V, class W> V operator OPERATOR(const V& a, const W& /*b*/) {      \
    static_assert(!IsSymbolic<V>, "a model has no " #OPERATOR ": " IN_ITS_PLACE);         \
    return a;                                                                             \
  }
COSIM_NO_MODEL_HAS(/, "by a power of two it is shift_right(a, n)")
COSIM_NO_MODEL_HAS(%, "by a power of two it is low_bits(a, n)")
COSIM_NO_MODEL_HAS(<<, "write shift_left(a, n)")
COSIM_NO_MODEL_HAS(>>, "write shift_right(a, n)")
#undef COSIM_NO_MODEL_HAS
// clang-format on

}  // namespace cosim
