// The cells of a model or of its ports: its values one by one, with their names.
#pragma once

#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "model/clocked/fields.h"

namespace cosim::clocked {

/// What is said of a cell by its member's type and name.
struct Label {
  std::string name;           ///< "left", "store[3]", "head.tag"; the path of an At
  std::string_view block;     ///< of a Source, else ""
  bool is_unreset = false;    ///< of an Unreset
  bool is_auxiliary = false;  ///< of an Auxiliary
};

/// Calls visit(label, cell) for each value in an object: a value, an Array, or a plain struct,
/// whose members come in their order.
template <class T, class Visit>
void for_each_cell(T& object, const Visit& visit, Label label = {}) {
  using Plain = std::remove_const_t<T>;
  if constexpr (Value<Plain> || ArrayLike<Plain>) {  // a struct's members are the user's
    if constexpr (requires { Plain::path; }) label.name = Plain::path;
    if constexpr (requires { Plain::block; }) label.block = Plain::block;
    if constexpr (requires { Plain::is_unreset; }) label.is_unreset = true;
    if constexpr (requires { Plain::is_auxiliary; }) label.is_auxiliary = true;
  }
  if constexpr (Value<Plain>) {
    visit(std::as_const(label), object);
  } else if constexpr (ArrayLike<Plain>) {
    for (int i = 0; i < Plain::size; ++i) {
      Label of_element = label;
      of_element.name += '[' + std::to_string(i) + ']';
      auto&& element = object[i];  // of a const array a copy
      for_each_cell(element, visit, of_element);
    }
  } else if constexpr (!reflect::Struct<Plain>) {
    reflect::check_struct<Plain>();
  } else {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      [[maybe_unused]] const auto one = [&](auto& member, std::string_view name) {
        Label of_member = label;
        of_member.name += (label.name.empty() ? "" : ".") + std::string(name);
        for_each_cell(member, visit, of_member);
      };
      [[maybe_unused]] auto all = reflect::tie(object);
      (one(std::get<I>(all), reflect::name<Plain, I>()), ...);
    }
    (std::make_index_sequence<reflect::members<Plain>>());
  }
}

/// What a register holds for a value: its bits, or the code of a OnesComplement.
template <Value T>
constexpr auto code_of(const T& cell) {
  if constexpr (requires { cell.code(); }) {
    return cell.code();
  } else {
    return UInt<T::width>(Inside::base(cell));
  }
}
template <Value T>
constexpr void set_code(T& cell, const UInt<T::width>& code) {
  if constexpr (requires { T::from_code(code); }) {
    static_cast<Base<T>&>(cell) = T::from_code(code);
  } else {
    static_cast<Base<T>&>(cell) = code;
  }
}

}  // namespace cosim::clocked
