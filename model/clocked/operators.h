// The operators of values. An expression is exact: its type grows, as those of ac_int do.
//
//   a + b       one bit more than the smallest type that holds both
//   a - b       the same, with a sign
//   a * b       the bits of both together
//   a / b       rounded to 0; the bits of a, and one more where b has a sign. By 0: all bits set
//   a % b       the bits and the sign of a. By 0: a
//   a & b       the type of a UInt beside a number with a sign: x & 3 is as wide as x
//   a | b ...   else the smallest type that holds both; ~a keeps its own
//   a << n      n more bits: as many as a UInt n can be; of an int n, as many as a has, or 64
//   a >> n      the bits of a; an Int keeps its sign
//   a == b ...  a Bit. Numbers are compared, not bit patterns: Int<4>(-1) is not UInt<4>(15)
//   a && b, !a  a Bit. Both sides are computed, for a symbol has no other way. A number of C++
//               before && is C++'s own: b is computed only where it is true, and then forks
//
// A number of C++ stands for an Int or a UInt of its bits, an int for an Int<32>. No type has more
// than 4,096 bits: upper ones are lost.
#pragma once

#include <stdexcept>

#include "model/clocked/value.h"

namespace cosim::clocked {

template <class A, class B>
concept Operands = Operand<A> && Operand<B> &&(Value<A> || Value<B>);

constexpr int at_most(int width) { return std::min(width, most_bits); }

/// The operation on a and b as numbers of type K, which holds both and the result.
template <Op op, class K, class A, class B>
constexpr K operated(const A& a, const B& b) {
  const K x(a), y(b);
#ifdef COSIM_SYMBOLIC
  if (Inside::is_symbol(x) || Inside::is_symbol(y)) {
    const Id m = Inside::node(x), n = Inside::node(y);
    constexpr Op made = op == Op::udiv && K::is_signed   ? Op::sdiv
                        : op == Op::urem && K::is_signed ? Op::srem
                                                         : op;
    const Id r = graph.make(made, K::width, m, n);
    if constexpr (made != Op::sdiv) return Inside::of<K>(r);
    return Inside::of<K>(graph.ite(graph.is_not_zero(n), r, Inside::node(K(-1))));
  }
#endif
  const typename K::Rep r = computed<op, K::is_signed>(Inside::rep(x), Inside::rep(y));
  if constexpr (op != Op::udiv) return K(Inside{}, r);
  return K(Inside{}, wrapped<K::width, K::is_signed>(r));  // of a division by 0
}

template <bool is_equal, class A, class B>
constexpr Bit compared(const A& a, const B& b) {
  using K = Both<A, B>;
  const K x(a), y(b);
#ifdef COSIM_SYMBOLIC
  if (Inside::is_symbol(x) || Inside::is_symbol(y)) {
    constexpr Op op = is_equal ? Op::eq : K::is_signed ? Op::slt : Op::ult;
    return Inside::of<Bit>(graph.make(op, 1, Inside::node(x), Inside::node(y)));
  }
#endif
  if constexpr (is_equal) return Bit(Inside::rep(x) == Inside::rep(y));
  return Bit(less<K::is_signed>(Inside::rep(x), Inside::rep(y)));
}

/// How far to shift, 0 to 4,096.
template <class N>
constexpr int amount(const N& n) {
  static_assert(!Value<N> || !Base<N>::is_signed,
                "a shift or an index is unsigned: make it a UInt");
  const auto base = Inside::base(n);
  using U = Base<N>;
  if (U::is_signed && is_negative<U::is_signed>(Inside::rep(base))) {
    throw std::out_of_range("a shift or an index is below 0");
  }
  const auto wide = resized<Rep<U::width + 14, false>, false>(Inside::rep(base));
  return wide < Rep<U::width + 14, false>(most_bits)
             ? static_cast<int>(resized<std::uint64_t, false>(wide))
             : most_bits;
}

#ifdef COSIM_SYMBOLIC
/// A shift of a, taken as a number of type K, in the graph.
template <Op op, class K, class A, class N>
K shifted_symbol(const A& a, const N& n) {
  using Room = Integer<std::max(K::width, Base<N>::width), K::is_signed>;
  static_assert(!Base<N>::is_signed || Native<N>,
                "a shift or an index is unsigned: make it a UInt");
  if constexpr (Native<N>) amount(n);  // which throws where it is below 0
  const Id by = Inside::node(UInt<Room::width>(n));
  return K(Inside::of<Room>(graph.make(op, Room::width, Inside::node(Room(K(a))), by)));
}
#endif

/// a * 2^n modulo the bits of its type.
template <Value A, Operand N>
constexpr Base<A> kept_left(const A& a, const N& n) {
  using K = Base<A>;
#ifdef COSIM_SYMBOLIC
  if (Inside::is_symbol(Inside::base(a)) || Inside::is_symbol(Inside::base(n))) {
    return shifted_symbol<Op::sll, K>(a, n);
  }
#endif
  const int by = amount(n);
  if (by >= K::width) return K(0);
  return K(Inside{}, wrapped<K::width, K::is_signed>(
                         static_cast<typename K::Rep>(Inside::rep(Inside::base(a)) << by)));
}

template <class A, class N>
constexpr int growth() {
  if constexpr (Native<N>) return std::max(64, Base<A>::width);
  if constexpr (Base<N>::width < 12) return (1 << Base<N>::width) - 1;
  return most_bits;
}
template <Value A, Operand N>
constexpr auto operator<<(const A& a, const N& n) {
  if constexpr (Native<N>) {
    if (amount(n) > growth<A, N>()) throw std::out_of_range("a << n: n is more than 64");
  }
  return kept_left(Integer<at_most(Base<A>::width + growth<A, N>()), Base<A>::is_signed>(a), n);
}
template <Value A, Operand N>
constexpr Base<A> operator>>(const A& a, const N& n) {
  using K = Base<A>;
#ifdef COSIM_SYMBOLIC
  if (Inside::is_symbol(Inside::base(a)) || Inside::is_symbol(Inside::base(n))) {
    return shifted_symbol < K::is_signed ? Op::sra : Op::srl, K > (a, n);
  }
#endif
  return K(Inside{}, shifted_right<K::is_signed>(Inside::rep(Inside::base(a)), amount(n)));
}

template <class A, class B>
requires Operands<A, B>
constexpr auto operator+(const A& a, const B& b) {
  using K = Both<A, B>;
  return operated<Op::add, Integer<at_most(K::width + 1), K::is_signed>>(a, b);
}
template <class A, class B>
requires Operands<A, B>
constexpr auto operator-(const A& a, const B& b) {
  return operated<Op::sub, Int<at_most(Both<A, B>::width + 1)>>(a, b);
}
template <class A, class B>
requires Operands<A, B>
constexpr auto operator*(const A& a, const B& b) {
  using K = Integer<at_most(Base<A>::width + Base<B>::width), Both<A, B>::is_signed>;
  return operated<Op::mul, K>(a, b);
}
template <class A, class B>
requires Operands<A, B>
constexpr auto operator/(const A& a, const B& b) {
  using R = Integer<at_most(Base<A>::width + Base<B>::is_signed), Both<A, B>::is_signed>;
  return R(operated<Op::udiv, Both<R, Both<A, B>>>(a, b));
}
template <class A, class B>
requires Operands<A, B>
constexpr Base<A> operator%(const A& a, const B& b) { return operated<Op::urem, Both<A, B>>(a, b); }

#define COSIM_OPERATOR(OP, RESULT) \
  template <class A, class B>      \
  requires Operands<A, B>          \
  constexpr auto operator OP(const A& a, const B& b) { return RESULT; }
/// The type of a & b: where one has no sign, the result has none and is no wider.
template <class A, class B>
using Masked = std::conditional_t<Base<A>::is_signed == Base<B>::is_signed, Both<A, B>,
                                  std::conditional_t<Base<A>::is_signed, Base<B>, Base<A>>>;

#define COSIM_BOTH(OP) (operated<OP, Both<A, B>>(a, b))
COSIM_OPERATOR(&, (operated<Op::band, Masked<A, B>>(a, b)))
COSIM_OPERATOR(|, COSIM_BOTH(Op::bor))
COSIM_OPERATOR(^, COSIM_BOTH(Op::bxor))
COSIM_OPERATOR(==, (compared<true>(a, b)))
COSIM_OPERATOR(!=, (!compared<true>(a, b)))
COSIM_OPERATOR(<, (compared<false>(a, b)))
COSIM_OPERATOR(>, (compared<false>(b, a)))
COSIM_OPERATOR(<=, (!compared<false>(b, a)))
COSIM_OPERATOR(>=, (!compared<false>(a, b)))
#undef COSIM_BOTH

template <class A, class B>
concept WithFloating = (Value<A> && std::floating_point<B>) || (std::floating_point<A> && Value<B>);
#define COSIM_FLOATING(OP)                                                                        \
  template <class A, class B>                                                                     \
  requires WithFloating<A, B>                                                                     \
  constexpr A operator OP(const A& a, const B&) {                                                 \
    static_assert(!WithFloating<A, B>, "a model computes with integers: 3 * a / 2, not 1.5 * a"); \
    return a;                                                                                     \
  }
COSIM_FLOATING(+)
COSIM_FLOATING(-)
COSIM_FLOATING(*)
COSIM_FLOATING(/)
#undef COSIM_FLOATING
#undef COSIM_OPERATOR

#define COSIM_ASSIGNMENT(OP)                      \
  template <Value A, Operand B>                   \
  constexpr A& operator OP##=(A& a, const B& b) { \
    return a = A(a OP b);                         \
  }
COSIM_ASSIGNMENT(+)
COSIM_ASSIGNMENT(-)
COSIM_ASSIGNMENT(*)
COSIM_ASSIGNMENT(/)
COSIM_ASSIGNMENT(%)
COSIM_ASSIGNMENT(&)
COSIM_ASSIGNMENT(|)
COSIM_ASSIGNMENT(^)
COSIM_ASSIGNMENT(<<)
COSIM_ASSIGNMENT(>>)
#undef COSIM_ASSIGNMENT

template <Value A>
constexpr A& operator++(A& a) {
  return a += 1;
}
template <Value A>
constexpr A& operator--(A& a) {
  return a -= 1;
}
template <Value A>
constexpr A operator++(A& a, int) {
  const A before = a;
  a += 1;
  return before;
}
template <Value A>
constexpr A operator--(A& a, int) {
  const A before = a;
  a -= 1;
  return before;
}

template <Value A>
constexpr Base<A> operator~(const A& a) {
  return operated<Op::bxor, Base<A>>(Inside::base(a), Base<A>(-1));
}
template <Value A>
constexpr auto operator-(const A& a) {
  return Base<A>(0) - a;
}
template <Value A>
constexpr Bit operator!(const A& a) {
  return compared<true>(a, Base<A>(0));
}
/// Whether a is not 0.
template <Operand A>
constexpr Bit truth(const A& a) {
  if constexpr (std::same_as<Base<A>, Bit>) {
    return Inside::base(a);
  } else {
    return a != Base<A>(0);
  }
}
template <Value A, Operand B>
constexpr Bit operator&&(const A& a, const B& b) {
  return truth(a) & truth(b);
}
template <Value A, Operand B>
constexpr Bit operator||(const A& a, const B& b) {
  return truth(a) | truth(b);
}

/// a if c is not 0, else b, in the smallest type that holds both. It does not fork.
template <Operand C, Operand A, Operand B>
constexpr Both<A, B> mux(const C& c, const A& a, const B& b) {
  const Both<A, B> x(a), y(b);
#ifdef COSIM_SYMBOLIC
  const Bit is(truth(c));
  if (Inside::is_symbol(is)) {
    return Inside::of<Both<A, B>>(graph.ite(Inside::node(is), Inside::node(x), Inside::node(y)));
  }
#endif
  return static_cast<bool>(truth(c)) ? x : y;
}

/// The bits of a in front of those of b, and so on: {a, b} in Verilog.
template <Value A>
constexpr UInt<Base<A>::width> cat(const A& a) {
  return a;
}
template <class A, class B, class... More>
constexpr auto cat(const A& a, const B& b, const More&... more) {
  static_assert(Value<A> && Value<B> && (Value<More> && ...),
                "cat() takes values, whose widths are known: UInt<3>(5) in place of 5");
  constexpr int high = Base<A>::width, low = Base<B>::width;
  static_assert(high + low <= most_bits, "a value has 1 to 4096 bits");
  const UInt<high + low> x(UInt<high>(Inside::base(a)));
  return cat(kept_left(x, low) | UInt<low>(Inside::base(b)), more...);
}

/// Whether all bits are 1; at least one; an odd number of them.
template <Value A>
constexpr Bit reduce_and(const A& a) {
  return UInt<Base<A>::width>(a) == ~UInt<Base<A>::width>(0);
}
template <Value A>
constexpr Bit reduce_or(const A& a) {
  return truth(a);
}
template <Value A>
constexpr Bit reduce_xor(const A& a) {
  UInt<Base<A>::width> x(Inside::base(a));
  for (int n = 1; n < Base<A>::width; n *= 2) x = x ^ x >> n;
  return x;
}

}  // namespace cosim::clocked
