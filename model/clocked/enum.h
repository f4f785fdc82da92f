// Fields whose numbers have names: those of an enum.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include "model/clocked/fields.h"
#include "model/clocked/says.h"

namespace cosim::clocked {
namespace enumerators {

// What has no name is printed as "(E)7".
template <class E, std::size_t I>
inline constexpr bool is_named =
    reflect::named<static_cast<E>(I)>().find(')') == std::string_view::npos;

template <class E, std::size_t I = 0>
consteval std::size_t count() {
  if constexpr (is_named<E, I>) {
    return count<E, I + 1>();
  } else {
    return I;
  }
}

template <auto V>
struct Spelled {
  static constexpr auto text = [] {
    constexpr std::string_view name = reflect::named<V>();
    std::array<char, name.size() + 1> with_end{};
    std::copy(name.begin(), name.end(), with_end.begin());
    return with_end;
  }();
};

template <class E>
inline constexpr auto names = []<std::size_t... I>(std::index_sequence<I...>) {
  return std::array<const char*, sizeof...(I)>{Spelled<static_cast<E>(I)>::text.data()...};
}
(std::make_index_sequence<count<E>()>());

}  // namespace enumerators

/// One of the enumerators of E, which count from 0 on: enum class E { red, green }. Reports, cases
/// and coverage show their names, and each is drawn equally often. W: its bits in the RTL.
template <class E, int W = std::max(clog2(enumerators::count<E>()), 1)>
struct Enum : Described<UInt<W>> {
  static_assert(
      requires { E{0}; }, "the enum of an Enum is an enum class, or has a type behind a colon");
  static_assert(enumerators::count<E>() >= 1, "the enumerators of an Enum count from 0 on");
  static constexpr std::span<const char* const> names = enumerators::names<E>;

  using Described<UInt<W>>::Described;
  template <std::same_as<E> X>
  constexpr Enum(X value) : Described<UInt<W>>(static_cast<int>(value)) {}  // NOLINT
  constexpr explicit operator E() const {
    return static_cast<E>(static_cast<int>(static_cast<const UInt<W>&>(*this)));
  }
  /// The enumerator's name, "?" for a value that has none.
  constexpr const char* name() const {
    const auto i = static_cast<std::size_t>(static_cast<const UInt<W>&>(*this));
    return i < names.size() ? names[i] : "?";
  }
  friend constexpr Bit operator==(const Enum& a, E b) {
    return static_cast<const UInt<W>&>(a) == static_cast<int>(b);
  }
  friend constexpr Bit operator!=(const Enum& a, E b) { return !(a == b); }
};

/// Of cases(): a sentence for each enumerator, its name.
template <class E, int W>
constexpr auto values(const Enum<E, W>& field) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Stated, sizeof...(I)>{
        Stated{enumerators::names<E>[I], field == static_cast<E>(I)}...};
  }
  (std::make_index_sequence<enumerators::count<E>()>());
}

}  // namespace cosim::clocked
