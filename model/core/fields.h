// What a record of a design consists of: its fields, as data, and its cells, one by one. Both come
// from the members of a struct (model/clocked/records.h).
//
// Code for records of any design works on cells. A cell is a field that is no array, or one element
// of an array. A record has all cells of its arrays at their full size. Elements that a shape does
// not have are 0, and their width is 0.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

#include "model/core/array.h"
#include "model/core/value.h"

namespace cosim {

/// How a field's bits are read.
enum class Format {
  flag,             ///< one bit
  bits,             ///< a bit string
  number,           ///< a number >= 0
  twos_complement,  ///< a signed number
  ones_complement,  ///< a signed number
};

/// What an input of one bit says of a clock on a step: nothing, or whether it rises or falls.
enum class Edge { none, rising, falling };

/// A cell: a field, or an element of one that is an array.
struct Field {
  const char* name;
  int width;  ///< bits, 1 to 64; 0: an element that this shape does not have
  Format format;
  const char* source;  ///< pin or block number, "" where the source has none
  const char* meaning;
  int fraction = 0;        ///< bits of a number after the binary point, 0 to 18
  const char* net = "";    ///< where it is in the RTL: "count", or below the top, "fifo.count[3:0]"
  bool unreset = false;    ///< a reset leaves it as it is: the model takes its value from the RTL
  int index = -1;          ///< of an element, from 0; -1: no array
  int low = 0;             ///< of an element: its first bit where the elements fill a net
  bool is_word = false;    ///< of an element: it is a word of one wide number
  Edge edge = Edge::none;  ///< of an input that is a clock: where registers take it
  bool is_placed = false;  ///< at() says its net, be it the field's own name
  /// Of an input that is no pin: the register of the state, the first of a synchronizer, whose bits
  /// it has take the new value (synchronizer.h); null of any other.
  const char* synchronizer = nullptr;
  const char* const* names = nullptr;  ///< of the values below `named`
  std::size_t named = 0;
};

/// The name for a person and in files: "count", of an element "store[3]", of a word of a wide
/// number "line[127:64]".
inline std::string label_of(const Field& field) {
  if (field.index < 0) return field.name;
  std::string name = field.name;
  name += '[';
  if (field.is_word) {
    name += std::to_string(field.low + field.width - 1) + ':' + std::to_string(field.low);
  } else {
    name += std::to_string(field.index);
  }
  return name + ']';
}

constexpr bool is_signed(const Field& field) {
  return field.format == Format::twos_complement || field.format == Format::ones_complement;
}

/// The number that a field's code stands for, in units of its lowest bit: in quarters where two
/// bits are its fraction. An unsigned code of 64 bits stays a bit pattern.
constexpr Word units_of(const Field& field, Word code) {
  if (field.format == Format::twos_complement) return from_twos_complement(code, field.width);
  if (field.format == Format::ones_complement) return from_ones_complement(code, field.width);
  return code;
}

/// Whether a field of a model's state can be `number`: signed formats hold as much on both sides.
constexpr bool is_state(const Field& field, Word number) {
  switch (field.format) {
    case Format::flag:
    case Format::bits:
    case Format::number:
      return low_bits(number, field.width) == number;
    case Format::twos_complement:
      return from_twos_complement(low_bits(number, field.width), field.width) == number;
    case Format::ones_complement:
      return number <= ones(field.width - 1) && number >= -ones(field.width - 1);
  }
  return false;
}

/// One parameter of a design's RTL: a number, or a text.
struct Parameter {
  const char* name;
  int value = 0;
  const char* text = nullptr;  ///< null where it is a number

  constexpr Parameter(const char* its_name, int number) : name(its_name), value(number) {}
  constexpr Parameter(const char* its_name, const char* its_text)
      : name(its_name), text(its_text) {}
};

/// "5", "FAST"
inline std::string to_text(const Parameter& p) {
  return p.text != nullptr ? p.text : std::to_string(p.value);
}

/// The cells of a record as an array of words, in the order of its table.
template <class Record>
using Words = std::array<Word, Record::size>;

/// Calls visit(member, i) for each field's pointer to member, in the order of the table; i is the
/// number of its first cell, a constant by its type.
template <class Record, class Visit>
constexpr void for_each_member(Visit visit) {
  Record::each_member(visit);
}

namespace detail {

template <class V>
inline constexpr int elements_of = 0;
template <class V, int N>
inline constexpr int elements_of<Array<V, N>> = N;

template <class Pointer>
struct MemberCell {
  Pointer pointer;
  template <class Record>
  constexpr auto& operator()(Record& r) const {
    return r.*pointer;
  }
};
template <class Pointer>
struct ElementCell {
  Pointer pointer;
  int index;
  template <class Record>
  constexpr auto& operator()(Record& r) const {
    return (r.*pointer)[index];
  }
};

template <class Record, class Pointer>
inline constexpr int elements_at =
    elements_of<std::remove_cvref_t<decltype(std::declval<Record&>().*std::declval<Pointer>())>>;

}  // namespace detail

/// Calls visit(cell, i) for each cell; cell(r) is the one of the record r.
template <class Record, class Visit>
constexpr void for_each_cell(Visit visit) {
  for_each_member<Record>([&](auto member, std::size_t first) {
    using Pointer = decltype(member);
    constexpr int n = detail::elements_at<Record, Pointer>;
    if constexpr (n == 0) {
      visit(detail::MemberCell<Pointer>{member}, first);
    } else {
      for (int i = 0; i < n; ++i) {
        visit(detail::ElementCell<Pointer>{member, i}, first + static_cast<std::size_t>(i));
      }
    }
  });
}

/// Calls visit(value) for a member that is a value, and for each element of one that is an array.
template <class V, class Visit>
constexpr void for_each_value(V& member, Visit visit) {
  visit(member);
}
template <class V, int N, class Visit>
constexpr void for_each_value(Array<V, N>& member, Visit visit) {
  for (V& value : member) visit(value);
}

/// a where c holds, else b, field by field.
template <class Record, class C>
constexpr Record select_record(C c, const Record& a, const Record& b) {
  Record r;
  for_each_member<Record>(
      [&](auto member, std::size_t) { r.*member = select(c, a.*member, b.*member); });
  return r;
}

template <class Record>
constexpr Words<Record> to_words(const Record& r) {
  Words<Record> words{};
  for_each_cell<Record>([&](auto cell, std::size_t i) { words[i] = cell(r); });
  return words;
}

template <class Record>
constexpr Record from_words(const Words<Record>& words) {
  Record r;
  for_each_cell<Record>([&](auto cell, std::size_t i) { cell(r) = words[i]; });
  return r;
}

}  // namespace cosim
