// The types of members beside plain numbers: arrays, and numbers with a further property, such as
// the register's place in the RTL or its display.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

#include "model/clocked/operators.h"
#include "model/clocked/reflect.h"

namespace cosim::clocked {

template <class T>
concept ArrayLike = requires {
  typename T::Element;
};

/// A type from which a T, or a type derived from it, can be made: a number, a T, a base of T.
template <class X, class T>
concept MadeInto = Operand<X> || std::derived_from<T, X>;

/// A T of zeros: a value, an Array, or a struct of them.
template <class T>
constexpr T zero();
struct Zero {
  template <class T>
  constexpr operator T() const {  // NOLINT
    return zero<T>();
  }
};
template <class T, std::size_t... I>
constexpr T zeros(std::index_sequence<I...>) {
  return T{(static_cast<void>(I), Zero{})...};
}
template <class T>
constexpr T zero() {
  if constexpr (Value<T> || ArrayLike<T>) {
    return T(0);
  } else {
    return zeros<T>(std::make_index_sequence<reflect::members<T>>());
  }
}

#ifdef COSIM_SYMBOLIC
/// a where c is not 0, else b: each value of a struct or an array.
template <class T>
T joined(const Bit& c, const T& a, T b) {
  if constexpr (Value<T>) {
    static_cast<Base<T>&>(b) = mux(c, Inside::base(a), Inside::base(b));
  } else if constexpr (ArrayLike<T>) {
    for (int i = 0; i < T::size; ++i) b[i] = joined(c, a[i], b[i]);
  } else {
    auto to = reflect::tie(b);
    const auto from = reflect::tie(a);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      ((std::get<I>(to) = joined(c, std::get<I>(from), std::get<I>(to))), ...);
    }
    (std::make_index_sequence<reflect::members<T>>());
  }
  return b;
}
#endif

/// N values, or structs of values; N is 1 or more. The index i of a[i] is a number of C++ from 0 to
/// N - 1, else std::out_of_range is thrown, or a UInt: outside of the array a[i] reads 0, and
/// writing does nothing. If elements are structs and i is a UInt, a[i].x can be read in a model
/// that is exported; to write, assign the whole element.
template <class T, int N>
class Array {
  static_assert(N >= 1, "an Array has at least one element");

 public:
  using Element = T;
  static constexpr int size = N;

  template <class Never = void>
  Array() {
    static_assert(!std::is_void_v<Never>,
                  "this Array has no initial value: write = 0, or = {1, 2, ...}; of registers that "
                  "no reset reaches it is an Unreset<Array<...>>");
  }
  /// All elements have this value.
  template <MadeInto<T> X>
  constexpr Array(const X& x) {
    for (Slot& slot : slots_) static_cast<T&>(slot) = fill<X>(x);
  }
  /// The first elements; the others are 0.
  constexpr Array(std::initializer_list<T> first) {
    if (first.size() > N) throw std::out_of_range("an Array has more initial values than elements");
    for (Slot& slot : slots_) static_cast<T&>(slot) = zero<T>();  // else GCC 12 loses the others
    int i = 0;
    for (const T& x : first) (*this)[i++] = x;
  }

  template <Operand I>
  constexpr decltype(auto) operator[](const I& i) {
#ifdef COSIM_SYMBOLIC
    if constexpr (Value<I>) {
      const auto write = [this, i](const T& x) {
        for (int k = 0; k < N; ++k) (*this)[k] = joined(i == k, x, (*this)[k]);
      };
      return Place<T, decltype(write)>(std::as_const(*this)[i], write);
    } else {
      return static_cast<T&>(slots_[index(i)]);
    }
#else
    const std::size_t at = index(i);
    if constexpr (Value<I> && may_be_outside<I>) {
      if (at >= N) return nowhere();
    }
    return static_cast<T&>(slots_[at]);
#endif
  }
  template <Operand I>
  constexpr T operator[](const I& i) const {
#ifdef COSIM_SYMBOLIC
    if constexpr (Value<I>) return read(Inside::base(i), 0, Base<I>::width - 1);
#endif
    const std::size_t at = index(i);
    if constexpr (Value<I>) {
      if (may_be_outside<I> && at >= N) return zero<T>();
    }
    return slots_[at];
  }
  constexpr auto begin() { return slots_.begin(); }
  constexpr auto begin() const { return slots_.begin(); }
  constexpr auto end() { return slots_.end(); }
  constexpr auto end() const { return slots_.end(); }

 private:
  struct Slot : T {
    constexpr Slot() : T(zero<T>()) {}
  };
  static T& nowhere() {
    static thread_local Slot slot;
    return slot = Slot();
  }
  template <class I>
  static constexpr bool may_be_outside = Base<I>::width > 30 || N < (1LL << Base<I>::width % 31);

  template <class X>
  static constexpr T fill(const X& x) {
    if constexpr (Operand<X> && !std::is_constructible_v<T, X>) {
      return zero<T>();
    } else {
      return T(x);
    }
  }
  template <class I>
  static constexpr std::size_t index(const I& i) {
    if constexpr (Native<I>) {
      if (i < 0 || static_cast<std::size_t>(i) >= N) {
        throw std::out_of_range("an Array of " + std::to_string(N) + " elements has no element " +
                                std::to_string(i));
      }
      return static_cast<std::size_t>(i);
    } else {
      static_assert(!Base<I>::is_signed, "a shift or an index is unsigned: make it a UInt");
      const auto& rep = Inside::rep(i);
      if constexpr (Base<I>::width <= 64) return static_cast<std::size_t>(rep);
      return rep < typename Base<I>::Rep(N) ? resized<std::size_t, false>(rep) : std::size_t{N};
    }
  }
#ifdef COSIM_SYMBOLIC
  // Of the elements from `first` on by bits `bit` to 0 of i.
  template <class I>
  T read(const I& i, long long first, int bit) const {
    if (first >= N) return zero<T>();
    if (bit < 0) return slots_[std::size_t(first)];
    const T low = read(i, first, bit - 1);
    const long long half = bit < 30 ? first + (1LL << bit) : N;
    return joined(i[bit], half < N ? read(i, half, bit - 1) : zero<T>(), low);
  }
#endif
  std::array<Slot, std::size_t(N)> slots_{};
};

/// A T whose derived type adds a property; it computes as a T does.
template <class T>
struct Described : T {
  using T::T;
  template <MadeInto<T> X>
  constexpr Described(const X& x) : T(x) {}  // NOLINT: it is a T
};

/// A register that no reset reaches: the model takes its first value over from the RTL, after the
/// reset. Unreset<UInt<9>>.
template <class T>
struct Unreset : Described<T> {
  static constexpr bool is_unreset = true;
  constexpr Unreset() : Described<T>(T(0)) {}
  using Described<T>::Described;
};

/// A parameter of the RTL that is a text: template <Text MODE>, compared by MODE == "FAST".
template <std::size_t N>
struct Text {
  char text[N];
  constexpr Text(const char (&from)[N]) {  // NOLINT: a text is written as it is
    for (std::size_t i = 0; i < N; ++i) text[i] = from[i];
  }
  constexpr operator std::string_view() const { return {text, N - 1}; }  // NOLINT
  friend constexpr bool operator==(const Text& a, std::string_view b) {
    return std::string_view(a) == b;
  }
};

/// A register or port that has another name in the RTL, or is below the top; PATH begins below the
/// top: At<"divider.count", UInt<8>>.
template <Text PATH, class T>
struct At : Described<T> {
  static constexpr std::string_view path = PATH;
  using Described<T>::Described;
};

/// A register or port with a number in a printed source, which reports show: Source<"16", Bit>.
template <Text BLOCK, class T>
struct Source : Described<T> {
  static constexpr std::string_view block = BLOCK;
  using Described<T>::Described;
};

/// A register that only the model has; it is not compared: Auxiliary<UInt<8>>.
template <class T>
struct Auxiliary : Described<T> {
  static constexpr bool is_auxiliary = true;
  using Described<T>::Described;
};

/// A number whose lowest BITS bits are shown as a fraction, in units of 2^-BITS; it computes as a
/// whole number: Fraction<2, Int<8>>.
template <int BITS, class T>
struct Fraction : Described<T> {
  static constexpr int fraction = BITS;
  using Described<T>::Described;
};

/// A value that is shown in hexadecimal: Hex<UInt<32>>.
template <class T>
struct Hex : Described<T> {
  static constexpr bool is_hex = true;
  using Described<T>::Described;
};

/// An input that is one of several clocks, whose registers use the rising edge: 1 on a step on
/// which that edge comes.
struct Rises : Bit {
  static constexpr int edge = 1;
  using Bit::Bit;
};
/// The same for a clock whose registers use the falling edge.
struct Falls : Bit {
  static constexpr int edge = -1;
  using Bit::Bit;
};

/// A member of In that is not a pin, but the outcome of metastability at the register REGISTER of
/// the same width, the first of a synchronizer. On a step on which two clocks have their edge, each
/// bit that is 1 takes the new value of the sampled signal, each other bit the old one. It is drawn
/// at random: Sampled<"w_first", UInt<4>>.
template <Text REGISTER, class T>
struct Sampled : Described<T> {
  static constexpr std::string_view sampled = REGISTER;
  using Described<T>::Described;
};

/// The bits needed to number n things, as Verilog's $clog2(n): clog2(8) is 3, clog2(1) is 0.
constexpr int clog2(std::int64_t n) {
  int bits = 0;
  while (bits < 62 && (std::int64_t{1} << bits) < n) ++bits;
  return bits;
}

constexpr int bits_for_range(std::int64_t low, std::int64_t high) {
  int width = 1;
  const auto holds = [&](std::int64_t v) {
    const int free = width - (low < 0 ? 1 : 0);
    return free >= 63 || ((v < 0 ? ~v : v) >> free) == 0;
  };
  while (!(holds(low) && holds(high))) ++width;
  return width;
}

/// A number of a Job, from LOW to HIGH inclusive: Range<0, 255>. Its type has the bits that the
/// range needs, and a sign if LOW is negative.
template <std::int64_t LOW, std::int64_t HIGH>
struct Range : Integer<bits_for_range(LOW, HIGH), (LOW < 0)> {
  static_assert(LOW <= HIGH, "the range is empty");
  static constexpr std::int64_t low = LOW, high = HIGH;
  using Number = Integer<bits_for_range(LOW, HIGH), (LOW < 0)>;
  constexpr Range() : Number(LOW > 0 ? LOW : HIGH < 0 ? HIGH : 0) {}
  template <Operand X>
  constexpr Range(const X& x) : Number(x) {}  // NOLINT
};

/// A number of W bits, |v| < 2^(W-1), whose register in the RTL is in ones' complement and adds
/// with end-around carry. A number v that is assigned, such as a sum of two, has |v| < 2^W - 1; if
/// it is out of range, 2^W - 1 is added or subtracted. The register's code of 0 is all zeros, or
/// all ones if MINUS_ZERO.
template <int W, bool MINUS_ZERO = false>
struct OnesComplement : Int<W> {
  static constexpr bool is_ones_complement = true, has_minus_zero = MINUS_ZERO;
  template <class Never = void>
  OnesComplement() : Int<W>() {}
  template <Operand T>
  constexpr OnesComplement(const T& x) : Int<W>(around(Inside::base(x))) {}
  /// The number with this code; both codes of 0 give 0.
  static constexpr OnesComplement from_code(const UInt<W>& code) {
    return Int<W + 1>(mux(code[W - 1], Int<W + 1>(code - all), Int<W + 1>(code)));
  }
  constexpr UInt<W> code() const {
    const Int<W>& v = *this;
    return mux(MINUS_ZERO ? v <= 0 : v < 0, v + all, v);
  }

 private:
  static constexpr UInt<W> all = UInt<W>(-1);
  template <class V>
  static constexpr Int<W> around(const V& v) {
    constexpr UInt<W> most = all >> 1;
    if constexpr (V::width < W) return v;
    return Int<W>(v + mux(v > most, 1, mux(v < -most, -1, 0)));  // 2^W - 1 less is 1 more in W bits
  }
};

/// An input that is the ones'-complement code of a number of W bits; 0 has both codes.
template <int W>
struct OnesComplementCode : Described<UInt<W>> {
  static constexpr bool is_ones_complement = true, has_minus_zero = false;
  using Described<UInt<W>>::Described;
  constexpr OnesComplement<W> number() const { return OnesComplement<W>::from_code(*this); }
};

}  // namespace cosim::clocked
