// The members of an aggregate, by number and with their names.
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace cosim::clocked::reflect {

/// Stands for an initial value of any member.
struct Any {
  template <class T>
  operator T() const;  // NOLINT: it is never called
};

template <class T, class... A>
concept Braced = requires {
  T{std::declval<A>()...};
};

template <class T, class... A>
consteval std::size_t count() {
  if constexpr (Braced<T, A..., Any>) {
    return count<T, A..., Any>();
  } else {
    return sizeof...(A);
  }
}
template <class T>
inline constexpr std::size_t members = count<std::remove_cvref_t<T>>();

// clang-format off
#define COSIM_TIE(k, ...)                                              \
  else if constexpr (n == (k)) {                                       \
    auto& [__VA_ARGS__] = object;                                      \
    return std::tie(__VA_ARGS__);                                      \
  }
#define COSIM_TIES(k, ...)                                             \
  COSIM_TIE(k + 1, __VA_ARGS__ a)                                      \
  COSIM_TIE(k + 2, __VA_ARGS__ a, b)                                   \
  COSIM_TIE(k + 3, __VA_ARGS__ a, b, c)                                \
  COSIM_TIE(k + 4, __VA_ARGS__ a, b, c, d)                             \
  COSIM_TIE(k + 5, __VA_ARGS__ a, b, c, d, e)                          \
  COSIM_TIE(k + 6, __VA_ARGS__ a, b, c, d, e, f)                       \
  COSIM_TIE(k + 7, __VA_ARGS__ a, b, c, d, e, f, g)                    \
  COSIM_TIE(k + 8, __VA_ARGS__ a, b, c, d, e, f, g, h)
#define COSIM_8(x) x##0, x##1, x##2, x##3, x##4, x##5, x##6, x##7,
#define COSIM_16 COSIM_8(p) COSIM_8(q)
#define COSIM_32 COSIM_16 COSIM_8(r) COSIM_8(s)
#define COSIM_48 COSIM_32 COSIM_8(t) COSIM_8(u)
// clang-format on

template <std::size_t>
inline constexpr Any any{};
template <class T, std::size_t... I, std::size_t... J>
consteval bool is_one_member(std::index_sequence<I...>, std::index_sequence<J...>) {
  return requires { T{any<I>..., {}, any<J>...}; };
}
/// Whether a member is a C array, which takes an Any for each element.
template <class T, std::size_t... I>
consteval bool has_c_array(std::index_sequence<I...>) {
  constexpr std::size_t n = sizeof...(I);
  return !(is_one_member<T>(std::make_index_sequence<I>(), std::make_index_sequence<n - 1 - I>()) &&
           ...);
}

/// What has members, unlike what containers are and C++ has by itself.
template <class T>
concept Struct = std::is_class_v<T> && !requires {
  typename T::value_type;
};

/// Stops the compiler where T is no type of a member, and no value or Array, either.
template <class T>
consteval void check_struct() {
  static_assert(Struct<T>,
                "a member of a model, of In or of Out is a UInt, an Int, a Bit, an Array or a "
                "struct of these: write UInt<8> in place of int, and Array<UInt<8>, 4> in place of "
                "std::array or std::vector");
}

/// Of structs of N members, more than 64: model/cosim/many_members.h.
template <std::size_t N>
struct Many;

/// References to the members of an aggregate of at most 64, none of them a base or a C array; with
/// many_members.h of at most 256.
template <class T>
constexpr auto tie(T& object) {
  static_assert(
      std::is_aggregate_v<std::remove_cv_t<T>>,
      "a model, its In and its Out are plain structs: no constructor, no virtual function, "
      "nothing private");
  constexpr std::size_t n = members<T>;
  static_assert(
      n <= 64 || requires { sizeof(Many<n>); },
      "a struct of a model has at most 64 members, or 256 behind a line #include "
      "<cosim/many_members.h>: put others into a struct of their own, or into an Array");
  static_assert(!has_c_array<std::remove_cv_t<T>>(std::make_index_sequence<n>()),
                "a member of a model is no C array: write Array<UInt<8>, 4> r in place of "
                "UInt<8> r[4]");
  if constexpr (n == 0) {
    return std::tie();
  }
  COSIM_TIES(0)
  COSIM_TIES(8, COSIM_8(p))
  COSIM_TIES(16, COSIM_16)
  COSIM_TIES(24, COSIM_16 COSIM_8(r))
  COSIM_TIES(32, COSIM_32)
  COSIM_TIES(40, COSIM_32 COSIM_8(t))
  COSIM_TIES(48, COSIM_48)
  COSIM_TIES(56, COSIM_48 COSIM_8(v))
  else {
    return Many<n>::tie(object);
  }
}
#undef COSIM_TIE
#undef COSIM_TIES
#undef COSIM_8
#undef COSIM_16
#undef COSIM_32
#undef COSIM_48

// An object that is not: its members have addresses, and these have names.
template <class T>
struct Nowhere {
  T object;
};
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wundefined-internal"  // of a type in an unnamed namespace
#endif
template <class T>
extern Nowhere<T> nowhere;
#ifdef __clang__
#pragma clang diagnostic pop
#endif

template <class T>
struct Boxed {  // Clang 14 prints the member of an address in a struct alone
  T value;
};
template <class T>
Boxed(T) -> Boxed<T>;

template <auto P>
consteval std::string_view named() {
  std::string_view text = __PRETTY_FUNCTION__;
  text = text.substr(text.find("P = "));
  text = text.substr(0, text.find(';'));
  text = text.substr(0, text.find_last_not_of(" ]});") + 1);
  return text.substr(text.find_last_of(".:") + 1);
}

/// The name of member I.
template <class T, std::size_t I>
consteval std::string_view name() {
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wundefined-var-template"
  return named<Boxed{&std::get<I>(tie(nowhere<T>.object))}>();
#pragma clang diagnostic pop
#else
  return named<&std::get<I>(tie(nowhere<T>.object))>();
#endif
}

}  // namespace cosim::clocked::reflect
