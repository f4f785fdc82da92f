// Integers of 1 to 4,096 bits as a program holds them, and what is done with them.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "model/core/wide.h"

namespace cosim::clocked {

inline constexpr int most_bits = 4096;

/// The operations of the graph, named and defined as in BTOR2.
enum class Op : std::uint8_t {
  constant,
  input,
  bnot,
  add,
  sub,
  mul,
  udiv,
  sdiv,
  urem,
  srem,
  band,
  bor,
  bxor,
  sll,
  srl,
  sra,
  eq,
  ult,
  slt,
  ite,
  concat,
  slice,
  uext,
  sext
};

/// A number without a sign modulo 2^(64 N), its lowest word first.
template <int N>
struct Words {
  static constexpr int last = N - 1;
  std::array<std::uint64_t, std::size_t(N)> word{};

  constexpr Words() = default;
  constexpr explicit Words(std::uint64_t low) { word[0] = low; }
  constexpr std::uint64_t& operator[](int i) { return word[std::size_t(i)]; }
  constexpr const std::uint64_t& operator[](int i) const { return word[std::size_t(i)]; }

  friend constexpr bool operator==(const Words&, const Words&) = default;
  friend constexpr std::strong_ordering operator<=>(const Words& a, const Words& b) {
    for (int i = N - 1; i > 0; --i) {
      if (a[i] != b[i]) return a[i] <=> b[i];
    }
    return a[0] <=> b[0];
  }
  constexpr Words operator~() const {
    Words r;
    for (int i = 0; i < N; ++i) r[i] = ~(*this)[i];
    return r;
  }
  friend constexpr Words operator&(Words a, const Words& b) {
    for (int i = 0; i < N; ++i) a[i] &= b[i];
    return a;
  }
  friend constexpr Words operator|(Words a, const Words& b) {
    for (int i = 0; i < N; ++i) a[i] |= b[i];
    return a;
  }
  friend constexpr Words operator^(Words a, const Words& b) {
    for (int i = 0; i < N; ++i) a[i] ^= b[i];
    return a;
  }
  friend constexpr Words operator+(Words a, const Words& b) { return sum(a, b, 0); }
  friend constexpr Words operator-(Words a, const Words& b) { return sum(a, ~b, 1); }
  friend constexpr Words operator*(const Words& a, const Words& b) {
    Words r;
    for (int i = 0; i < N; ++i) {
      std::uint64_t carry = 0;
      for (int j = 0; a[i] != 0 && i + j < N; ++j) {
        const Uint128 sum = Uint128{a[i]} * b[j] + r[i + j] + carry;
        r[i + j] = std::uint64_t(sum);
        carry = std::uint64_t(sum >> 64);
      }
    }
    return r;
  }
  /// 0 <= n; all bits go out where n is 64 N or more.
  friend constexpr Words operator<<(const Words& a, int n) {
    Words r;
    for (int i = N - 1, from = i - n / 64; from >= 0; --i, --from) {
      r[i] = a[from] << n % 64;
      if (n % 64 != 0 && from > 0) r[i] |= a[from - 1] >> (64 - n % 64);
    }
    return r;
  }
  friend constexpr Words operator>>(const Words& a, int n) {
    Words r;
    for (int i = 0, from = n / 64; from < N; ++i, ++from) {
      r[i] = a[from] >> n % 64;
      if (n % 64 != 0 && from + 1 < N) r[i] |= a[from + 1] << (64 - n % 64);
    }
    return r;
  }
  friend constexpr Words operator/(const Words& a, const Words& b) { return divided(a, b).first; }
  friend constexpr Words operator%(const Words& a, const Words& b) { return divided(a, b).second; }

 private:
  static constexpr Words sum(Words a, const Words& b, std::uint64_t carry) {
    for (int i = 0; i < N; ++i) {
      const Uint128 sum = Uint128{a[i]} + b[i] + carry;
      a[i] = std::uint64_t(sum);
      carry = std::uint64_t(sum >> 64);
    }
    return a;
  }
  struct Pair {
    Words first, second;
  };
  static constexpr Pair divided(const Words& a, const Words& b) {
    Pair r;
    for (int i = 64 * N - 1; i >= 0; --i) {
      const bool carry = r.second[N - 1] >> 63 != 0;
      r.second = r.second << 1;
      r.second[0] |= a[i / 64] >> i % 64 & 1;
      if (!carry && r.second < b) continue;
      r.second = r.second - b;
      r.first[i / 64] |= std::uint64_t{1} << i % 64;
    }
    return r;
  }
};

/// As many bits as any value has.
using Wide = Words<most_bits / 64>;

/// What holds a number of W bits, with a sign where S.
template <int W, bool S>
using Rep = std::conditional_t<
    W <= 64, std::conditional_t<S, std::int64_t, std::uint64_t>,
    std::conditional_t<W <= 128, std::conditional_t<S, Int128, Uint128>, Words<(W + 63) / 64>>>;

template <class R>
inline constexpr int words_of = 0;  // of a machine integer
template <int N>
inline constexpr int words_of<Words<N>> = N;
template <class R>
concept IsWords = words_of<R> >
0;

/// Whether v is below 0, where numbers of its kind have a sign.
template <bool S, class R>
constexpr bool is_negative(const R& v) {
  if constexpr (!S) {
    return false;
  } else if constexpr (IsWords<R>) {
    return v[R::last] >> 63 != 0;
  } else {
    return v < 0;
  }
}

/// v modulo the bits of To; with its sign in front where S.
template <class To, bool S, class R>
constexpr To resized(const R& v) {
  if constexpr (!IsWords<To> && !IsWords<R>) {
    return static_cast<To>(v);
  } else if constexpr (!IsWords<To>) {
    return static_cast<To>(Uint128{v[1]} << 64 | v[0]);
  } else {
    constexpr int n = IsWords<R> ? words_of<R> : int(sizeof(R) / 8);
    const std::uint64_t sign = is_negative<S>(v) ? ~std::uint64_t{0} : 0;
    To r;
    for (int i = 0; i < words_of<To>; ++i) {
      if constexpr (IsWords<R>) {
        r[i] = i < n ? v[i] : sign;
      } else {
        r[i] = i < n ? std::uint64_t(i == 0 ? v : v >> (sizeof(R) == 16 ? 64 : 0)) : sign;
      }
    }
    return r;
  }
}

/// The number of W bits, with a sign where S, that the lower W bits of v are.
template <int W, bool S, class R>
constexpr R wrapped(R v) {
  if constexpr (IsWords<R>) {
    v[R::last] = std::uint64_t(wrapped<W - 64 * R::last, S>(Rep<64, S>(v[R::last])));
    return v;
  } else if constexpr (W == 8 * sizeof(R)) {
    return v;
  } else if constexpr (S) {
    constexpr int rest = int(8 * sizeof(R)) - W;
    return static_cast<R>(v << rest) >> rest;
  } else {
    return v & static_cast<R>((R{1} << W) - 1);
  }
}

/// The operation on two numbers of W bits whose result is exact, or is to be wrapped. A quotient by
/// 0 has all bits set, a remainder by 0 is the dividend.
template <Op op, bool S, class R>
constexpr R computed(const R& a, const R& b) {
  constexpr bool wide_signed = S && IsWords<R>;
  if constexpr (op == Op::add) return a + b;
  if constexpr (op == Op::sub) return a - b;
  if constexpr (op == Op::mul) return a * b;
  if constexpr (op == Op::band) return a & b;
  if constexpr (op == Op::bor) return a | b;
  if constexpr (op == Op::bxor) return a ^ b;
  if constexpr (op == Op::udiv || op == Op::urem) {
    constexpr bool rest = op == Op::urem;
    if (b == R(0)) return rest ? a : R(~R(0));
    if constexpr (wide_signed) {
      const bool x = is_negative<S>(a), y = is_negative<S>(b);
      const R m = x ? R(0) - a : a, n = y ? R(0) - b : b;
      const R r = rest ? m % n : m / n;
      return (rest ? x : x != y) ? R(0) - r : r;
    } else {
      return rest ? a % b : a / b;
    }
  }
}

/// Whether a < b.
template <bool S, class R>
constexpr bool less(const R& a, const R& b) {
  if constexpr (S && IsWords<R>) {
    const bool x = is_negative<S>(a), y = is_negative<S>(b);
    return x != y ? x : a < b;
  } else {
    return a < b;
  }
}

/// a / 2^n, rounded down, 0 <= n.
template <bool S, class R>
constexpr R shifted_right(const R& a, int n) {
  constexpr int bits = IsWords<R> ? 64 * words_of<R> : int(8 * sizeof(R));
  if constexpr (IsWords<R>) {
    const R r = a >> n;
    return is_negative<S>(a) && n > 0 ? r | ~(~R() >> n) : r;
  } else {
    if (n >= bits) return is_negative<S>(a) ? R(~R{0}) : R{0};
    return a >> n;
  }
}

}  // namespace cosim::clocked
