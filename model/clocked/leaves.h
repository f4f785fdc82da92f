// The leaves of a model, of its ports or of a record of its jobs: its values, and its arrays of
// values, with all that their types and names say. Known when it is compiled.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "model/clocked/fields.h"

namespace cosim::clocked {

/// A text that is made while it is compiled.
struct LeafName {
  std::array<char, 256> text{};
  std::size_t size = 0;

  constexpr std::string_view view() const { return {text.data(), size}; }
  constexpr LeafName and_then(std::string_view more) const {
    LeafName n = *this;
    for (const char c : more) n.text[n.size++] = c;  // no constant where it is too long
    return n;
  }
  constexpr LeafName element(int i) const {
    LeafName n = and_then("[");
    int ten = 1;
    while (i / ten >= 10) ten *= 10;
    for (; ten > 0; ten /= 10) n.text[n.size++] = static_cast<char>('0' + i / ten % 10);
    return n.and_then("]");
  }
};

/// What is said of a leaf.
struct Leaf {
  LeafName name{};             ///< "left", "head.tag", of an element that is a struct "tags[3].on"
  std::string_view path{};     ///< of an At
  std::string_view block{};    ///< of a Source
  std::string_view sampled{};  ///< of a Sampled
  int width = 0;               ///< of an element
  int elements = 0;            ///< of an Array; 0: it is a value
  bool is_signed = false, is_ones_complement = false, has_minus_zero = false;
  bool is_hex = false, is_unreset = false, is_auxiliary = false;
  int fraction = 0;                      ///< bits of a Fraction
  int edge = 0;                          ///< of a clock: 1 it rises, -1 it falls
  std::int64_t low = 0, high = 0;        ///< of a Range
  std::span<const char* const> names{};  ///< of an Enum, of its values from 0 on

  template <class T>
  constexpr void say() {
    if constexpr (requires { T::path; }) path = T::path;
    if constexpr (requires { T::block; }) block = T::block;
    if constexpr (requires { T::sampled; }) sampled = T::sampled;
    if constexpr (requires { T::is_hex; }) is_hex = true;
    if constexpr (requires { T::is_unreset; }) is_unreset = true;
    if constexpr (requires { T::is_auxiliary; }) is_auxiliary = true;
    if constexpr (requires { T::fraction; }) fraction = T::fraction;
    if constexpr (requires { T::edge; }) edge = T::edge;
    if constexpr (requires { T::low; }) low = T::low;
    if constexpr (requires { T::high; }) high = T::high;
    if constexpr (requires { T::names; }) names = T::names;
    if constexpr (requires { T::is_ones_complement; }) {
      is_ones_complement = true;
      has_minus_zero = T::has_minus_zero;
    }
    if constexpr (Value<T>) {
      width = T::width;
      is_signed = T::is_signed;
    }
  }
};

namespace leaves {

template <class T, std::size_t I>
using MemberType =
    std::remove_reference_t<std::tuple_element_t<I, decltype(reflect::tie(std::declval<T&>()))>>;

template <class T>
concept Plain = Value<T> ||(ArrayLike<T>&& Value<typename T::Element>);

template <class T>
consteval std::size_t count() {
  if constexpr (Plain<T>) {
    return 1;
  } else if constexpr (ArrayLike<T>) {
    return std::size_t(T::size) * count<typename T::Element>();
  } else if constexpr (!reflect::Struct<T>) {
    reflect::check_struct<T>();
    return 0;
  } else {
    return []<std::size_t... I>(std::index_sequence<I...>) {
      return (std::size_t{0} + ... + count<MemberType<T, I>>());
    }
    (std::make_index_sequence<reflect::members<T>>());
  }
}

template <class T, std::size_t N>
constexpr void add(std::array<Leaf, N>& all, std::size_t& at, Leaf leaf) {
  if constexpr (Value<T> || ArrayLike<T>) leaf.say<T>();  // a struct's members are the user's
  if constexpr (Value<T>) {
    all[at++] = leaf;
  } else if constexpr (Plain<T>) {
    leaf.say<typename T::Element>();
    leaf.elements = T::size;
    all[at++] = leaf;
  } else if constexpr (ArrayLike<T>) {
    for (int i = 0; i < T::size; ++i) {
      Leaf element = leaf;
      element.name = leaf.name.element(i);
      add<typename T::Element>(all, at, element);
    }
  } else {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      [[maybe_unused]] const auto named = [&](std::string_view name) {
        Leaf member = leaf;
        if (leaf.name.size != 0) member.name = leaf.name.and_then(".");
        member.name = member.name.and_then(name);
        return member;
      };
      (add<MemberType<T, I>>(all, at, named(reflect::name<T, I>())), ...);
    }
    (std::make_index_sequence<reflect::members<T>>());
  }
}

template <class T>
consteval auto list() {
  std::array<Leaf, count<T>()> all{};
  std::size_t at = 0;
  add<T>(all, at, {});
  return all;
}

}  // namespace leaves

template <class T>
inline constexpr auto leaves_of = leaves::list<T>();

template <std::size_t FIRST, class T, class Visit>
constexpr void for_each_leaf_of(T&& object, const Visit& visit);

/// Calls visit(leaf, i) for each, i a constant by its type.
template <std::size_t FIRST = 0, class T, class Visit>
constexpr void for_each_leaf(T& object, const Visit& visit) {
  using Plain = std::remove_const_t<T>;
  if constexpr (leaves::Plain<Plain>) {
    visit(object, std::integral_constant<std::size_t, FIRST>());
  } else if constexpr (ArrayLike<Plain>) {
    constexpr std::size_t each = leaves::count<typename Plain::Element>();
    const auto element = [&](int i) -> decltype(auto) { return object[i]; };
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (for_each_leaf_of<FIRST + I * each>(element(int(I)), visit), ...);
    }
    (std::make_index_sequence<std::size_t(Plain::size)>());
  } else {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      [[maybe_unused]] constexpr auto first = [] {
        std::array<std::size_t, sizeof...(I) + 1> all{FIRST};
        std::size_t at = 0;
        ((all[at + 1] = all[at] + leaves::count<leaves::MemberType<Plain, I>>(), ++at), ...);
        return all;
      }();
      [[maybe_unused]] auto all = reflect::tie(object);
      (for_each_leaf<first[I]>(std::get<I>(all), visit), ...);
    }
    (std::make_index_sequence<reflect::members<Plain>>());
  }
}
// Of an object that may be a copy.
template <std::size_t FIRST, class T, class Visit>
constexpr void for_each_leaf_of(T&& object, const Visit& visit) {
  for_each_leaf<FIRST>(object, visit);
}

}  // namespace cosim::clocked
