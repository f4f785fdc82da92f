// Random expressions, the same text for values of a model and for big integers.
#pragma once

#include <concepts>
#include <type_traits>

#include "model/clocked/model.h"

namespace cosim::clocked::test {

constexpr unsigned mixed(unsigned x) {
  x = (x ^ x >> 16) * 0x45d9f3bu;
  x = (x ^ x >> 16) * 0x45d9f3bu;
  return x ^ x >> 16;
}

static_assert(std::same_as<decltype(UInt<8>(0) & 3), UInt<8>>);
static_assert(std::same_as<decltype(-1 & UInt<8>(0)), UInt<8>>);

/// An expression of a and b: what it consists of is drawn from SEED.
template <unsigned SEED, int DEPTH, class A, class B>
auto expression(const A& a, const B& b) {
  constexpr unsigned r = mixed(SEED);
  if constexpr (DEPTH == 0 || r % 8 == 0) {
    if constexpr (r >> 8 & 1) {
      return a;
    } else {
      return b;
    }
  } else {
    const auto x = expression<r + 1, DEPTH - 1>(a, b);
    const auto y = expression<r + 2, DEPTH - 1>(a, b);
    constexpr int constant = int(r >> 12 & 0xfff) - 1000, by = int(r >> 12 & 63);
    if constexpr (r % 16 == 1)
      return x - y;
    else if constexpr (r % 16 == 2)
      return x * y;
    else if constexpr (r % 16 == 3)
      return x / y;
    else if constexpr (r % 16 == 4)
      return x % y;
    else if constexpr (r % 16 == 5)
      return x & y;
    else if constexpr (r % 16 == 6)
      return x | y;
    else if constexpr (r % 16 == 7)
      return x ^ y;
    else if constexpr (r % 16 == 9)
      return x + constant;
    else if constexpr (r % 16 == 10)
      return x & constant;
    else if constexpr (r % 16 == 11)
      return constant - x;
    else if constexpr (r % 16 == 12)
      return x * constant;
    else if constexpr (r % 16 == 13)
      return -x;
    else if constexpr (r % 16 == 14)
      return x >> by;
    else if constexpr (r % 16 == 15)
      return x << by;
    else
      return x + y;
  }
}

/// The width of what is beside one of W bits.
constexpr int other(int w) { return (37 * w + 11) % 130 + 1; }

/// Expressions of a and b, of W bits and others, as a model's outputs.
template <int W, bool S, bool T, unsigned SEED>
struct Expressions {
  using A = Integer<W, S>;
  using B = Integer<other(W), T>;
  using E = decltype(expression<SEED, 2>(std::declval<A>(), std::declval<B>()));
  struct In {
    A a;
    B b;
    UInt<6> n;
  };
  struct Out {
    E e;
    Int<W + 3> kept;  // its lower bits
    Bit less, equal;  // than b
    Integer<W + 63, S> left;
    A right, written;
    Bit bit;
  };
  Out clock(const In& in) const {
    const E e = expression<SEED, 2>(in.a, in.b);
    A written = in.a;
    written.template slice<W - 1, W / 2>() = in.b;
    written[in.n] = in.b[0];
    return {.e = e,
            .kept = e,
            .less = e < in.b,
            .equal = e == in.b,
            .left = in.a << in.n,
            .right = in.a >> in.n,
            .written = written,
            .bit = in.a[in.n]};
  }
};

#ifdef COSIM_ALL_WIDTHS
using AllWidths = std::make_integer_sequence<int, 130>;
#else  // those beside the ends of a machine's words
using AllWidths = std::integer_sequence<int, 0, 1, 2, 3, 6, 7, 8, 14, 15, 16, 30, 31, 32, 33, 47,
                                        61, 62, 63, 64, 65, 66, 95, 126, 127, 128, 129>;
#endif

/// Calls visit.operator()<Expressions<...>>(name) for those widths, each less one.
template <class Visit, int... I>
void for_each_width(const Visit& visit, std::integer_sequence<int, I...>) {
  const auto name = [](int w) { return "expressions_" + std::to_string(w); };
  (visit.template operator()<Expressions<I + 1, I % 2 != 0, I % 4 / 2 != 0, 7919u * I>>(
       name(I + 1)),
   ...);
}

}  // namespace cosim::clocked::test
