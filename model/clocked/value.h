// Integers of a width: UInt<W>, Int<W> and Bit. Their operators are in operators.h.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "model/clocked/words.h"
#ifdef COSIM_SYMBOLIC
#include "model/clocked/ways.h"
#endif

namespace cosim::clocked {

template <int W, bool S>
class Integer;

/// A number >= 0 of W bits, 1 to 4,096.
template <int W>
using UInt = Integer<W, false>;
/// A number of W bits in two's complement, 1 to 4,096.
template <int W>
using Int = Integer<W, true>;
/// A number of one bit, 0 or 1; the result of a comparison. It is also a condition of if, && and
/// ||.
using Bit = UInt<1>;

template <int W, bool S>
Integer<W, S> base_of(const Integer<W, S>&);

/// An Integer, or a type derived from one.
template <class T>
concept Value = requires(const T& x) {
  base_of(x);
};
/// A number of C++ itself: a value of as many bits as its type has, bool of one.
template <class T>
concept Native = std::integral<T> ||(std::is_enum_v<T>&& std::convertible_to<T, std::int64_t>);
template <class T>
concept Operand = Value<T> || Native<T>;

template <class T>
struct BaseOf {
  using Type = Integer<std::same_as<T, bool> ? 1 : int(8 * sizeof(T)), std::is_signed_v<T>>;
};
template <class T>
requires std::is_enum_v<T>
struct BaseOf<T> : BaseOf<std::underlying_type_t<T>> {
};
template <Value T>
struct BaseOf<T> {
  using Type = decltype(base_of(std::declval<const T&>()));
};
/// The Integer that a value is, or that holds any number of a type of C++: int is an Int<32>.
template <class T>
using Base = typename BaseOf<T>::Type;

/// The smallest type that holds every number of A and of B.
template <class A, class B, bool S = Base<A>::is_signed || Base<B>::is_signed>
using Both = Integer<std::max(Base<A>::width + (S && !Base<A>::is_signed),
                              Base<B>::width + (S && !Base<B>::is_signed)),
                     S>;

/// Part of a value, read as a T and written in place: a bit, a slice. It lives as long as its
/// expression; `auto b = a[3]` is a copy that can be read alone.
template <class T, class Write>
class Place : public T {
 public:
  constexpr Place(const T& value, Write write) : T(value), write_(write) {}
  template <class X>
  requires(Operand<X> || std::same_as<X, T>) constexpr void operator=(const X& x) && {
    write_(T(x));
  }
  constexpr void operator=(const Place& x) && { write_(static_cast<const T&>(x)); }
#define COSIM_IN_PLACE(OP)                        \
  template <Operand X>                            \
  constexpr void operator OP##=(const X& x)&& {   \
    write_(T(static_cast<const T&>(*this) OP x)); \
  }
  COSIM_IN_PLACE(+)
  COSIM_IN_PLACE(-)
  COSIM_IN_PLACE(&)
  COSIM_IN_PLACE(|)
  COSIM_IN_PLACE(^)
#undef COSIM_IN_PLACE
 private:
  Write write_;
};

// What the library sees of a value.
struct Inside {
  template <class T>
  static constexpr Base<T> base(const T& x) {
    if constexpr (Native<T>) {
      return Base<T>(Inside{}, static_cast<typename Base<T>::Rep>(x));
    } else {
      return static_cast<const Base<T>&>(x);
    }
  }
  template <class T>
  static constexpr const auto& rep(const T& x) {
    return x.rep_;
  }
#ifdef COSIM_SYMBOLIC
  template <class T>
  static constexpr bool is_symbol(const T& x) {
    return x.node_ != 0;
  }
  /// The node of a value, in the graph from now on where it is a constant.
  template <class T>
  static Id node(const T& x) {
    return x.node_ != 0 ? x.node_ : graph.constant(T::width, resized<Wide, T::is_signed>(x.rep_));
  }
  /// The value of a node of its width.
  template <class T>
  static T of(Id node) {
    T r(Inside{}, {});
    if (const Wide* known = graph.known(node)) {
      r.rep_ = wrapped<T::width, T::is_signed>(resized<typename T::Rep, false>(*known));
    } else {
      r.node_ = node;
    }
    return r;
  }
#endif
};

template <int W, bool S>
class Integer {
  static_assert(W >= 1 && W <= most_bits, "a value has 1 to 4096 bits");

 public:
  static constexpr int width = W;
  static constexpr bool is_signed = S;
  using Rep = clocked::Rep<W, S>;

  template <class Never = void>
  Integer() {
    static_assert(
        !std::is_void_v<Never>,
        "this value has no initial value: write = 0, or what a reset makes it; a register "
        "that no reset reaches is an Unreset<...>");
  }
  /// The lower W bits of x.
  template <Operand T>
  constexpr Integer(const T& x) : rep_{} {
    take(Inside::base(x));
  }
  constexpr Integer(const Integer&) = default;
  constexpr Integer& operator=(const Integer&) & = default;
  template <class Never = void>
  constexpr const Integer& operator=(const Integer&) const& {
    static_assert(!std::is_void_v<Never>,
                  "a const value cannot be assigned to: In is const, and so is every register in a "
                  "function that is const; a clock() that changes registers is not const");
    return *this;
  }
  constexpr Integer(Inside, const Rep& rep) : rep_(rep) {}

  /// Whether it is not 0. For a symbol this is a fork: both ways are run.
  template <std::same_as<bool> B>
#ifdef COSIM_SYMBOLIC
  [[gnu::noinline]] explicit(W != 1 || S) operator B() const {
    if (node_ == 0) return rep_ != Rep(0);
    return ways.ask(graph.is_not_zero(node_), __builtin_return_address(0));
  }
#else
  constexpr explicit(W != 1 || S) operator B() const {
    return rep_ != Rep(0);
  }
#endif
  /// As a number of C++; upper bits are cut off, as by a cast of C++. Not for a symbol.
  template <class T>
  requires((Native<T> || std::floating_point<T>)&&!std::same_as<T, bool>) constexpr explicit
  operator T() const {
#ifdef COSIM_SYMBOLIC
    static_assert(
        std::same_as<T, bool>,
        "a symbol is no number of C++: keep it a UInt or an Int, or take value() of one of "
        "few bits, each number of which is then a way of its own");
#endif
    return static_cast<T>(resized<std::int64_t, S>(rep_));
  }
  /// As a number of C++, for switch. For a symbol each number of its type is a way of its own.
  constexpr std::int64_t value() const requires(W < 64 || (S && W == 64)) {
#ifdef COSIM_SYMBOLIC
    static_assert(W <= 12, "value() of a symbol takes a way for each number: at most 12 bits");
    if (node_ != 0) {
      std::int64_t v = 0;
      for (int i = 0; i < W; ++i) v |= std::int64_t{bool((*this)[i])} << i;
      return static_cast<std::int64_t>(Inside::rep(Integer(v)));
    }
#endif
    return static_cast<std::int64_t>(rep_);
  }

  /// Bit i, a number of C++ or a UInt; 0 outside. It can be assigned to; outside that does nothing.
  template <Operand I>
  constexpr Bit operator[](const I& i) const& {
    return UInt<W>(*this) >> i;
  }
  template <Operand I>
  constexpr auto operator[](const I& i) & {
    return bits<1>(i);
  }
  /// Bits high to low. It can be assigned to.
  template <int high, int low>
  constexpr auto slice() const& {
    static_assert(high < W && high >= low && low >= 0,
                  "slice<high, low>() is not within the value");
    return bits<high - low + 1>(low);
  }
  template <int high, int low>
  constexpr auto slice() & {
    static_assert(high < W && high >= low && low >= 0,
                  "slice<high, low>() is not within the value");
    return bits<high - low + 1>(low);
  }
  /// N bits from bit `low` on, a number of C++ or a UInt; 0 outside. It can be assigned to.
  template <int N, Operand I>
  constexpr UInt<N> bits(const I& low) const& {
    return UInt<W>(*this) >> low;
  }
  template <int N, Operand I>
  constexpr auto bits(const I& low) & {
    const auto write = [this, low](const UInt<N>& x) {
      using U = UInt<W>;
      const U mask = kept_left(U(~UInt<std::min(N, W)>(0)), low);
      *this = (U(*this) & ~mask) | kept_left(U(x), low);
    };
    return Place<UInt<N>, decltype(write)>(std::as_const(*this).template bits<N>(low), write);
  }
  /// n bits from bit `low` on as a number of W bits.
  template <Operand I>
  constexpr UInt<W> bits(const I& low, int n) const {
    return UInt<W>(UInt<W>(*this) >> low) & ~kept_left(UInt<W>(~UInt<W>(0)), n);
  }

 private:
  friend Inside;

  template <int V, bool U>
  constexpr void take(const Integer<V, U>& x) {
#ifdef COSIM_SYMBOLIC
    if (Inside::is_symbol(x)) {
      *this = Inside::of<Integer>(graph.resized(Inside::node(x), U, W));
      return;
    }
#endif
    rep_ = resized<Rep, U>(Inside::rep(x));
    if constexpr (S == U ? V > W : U || V >= W) rep_ = wrapped<W, S>(rep_);
  }

  Rep rep_;
#ifdef COSIM_SYMBOLIC
  Id node_ = 0;  // 0: it is the constant rep_
#endif
};

}  // namespace cosim::clocked

#include "model/clocked/operators.h"
