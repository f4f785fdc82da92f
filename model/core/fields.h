// One table of fields for each record of a design: from it come the struct, the comparison, the
// printing and every list of names. A table is a macro of rows
//
//   FIELD(name, width, format, source, meaning)
//
// `name` is the RTL's port or register; `width` in bits may use p, the design's parameters;
// `format` is a name of Format, followed by with_fraction(n) if the lowest n bits are a fraction,
// by at("PATH") if the RTL has it by another name or below the top module, and by unreset() if it
// is a register that no reset reaches; `source` is the number of the pin or block in the source.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

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

struct Field {
  const char* name;
  int width;  ///< bits, 1 to 64
  Format format;
  const char* source;  ///< pin or block number, "" where the source has none
  const char* meaning;
  int fraction = 0;      ///< bits of a number after the binary point, 0 to 18
  const char* net = "";  ///< where it is in the RTL: "count", or below the top, "fifo.count"
  bool unreset = false;  ///< a clear leaves it as it is: the model takes its value from the RTL
};

constexpr bool is_signed(const Field& field) {
  return field.format == Format::twos_complement || field.format == Format::ones_complement;
}

/// The number that a field's code stands for, in units of its last bit: quarters if its
/// fraction has two bits. An unsigned code of 64 bits stays a bit pattern.
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

/// The formats by the names that a table's rows use.
namespace row {

struct Notation {
  Format format;
  int fraction = 0;
  const char* net = nullptr;
  bool is_unreset = false;
  constexpr Notation with_fraction(int bits) const { return {format, bits, net, is_unreset}; }
  constexpr Notation at(const char* path) const { return {format, fraction, path, is_unreset}; }
  constexpr Notation unreset() const { return {format, fraction, net, true}; }
};
inline constexpr Notation flag{Format::flag};
inline constexpr Notation bits{Format::bits};
inline constexpr Notation number{Format::number};
inline constexpr Notation twos_complement{Format::twos_complement};
inline constexpr Notation ones_complement{Format::ones_complement};

constexpr Field field(const char* name, int width, Notation notation, const char* source,
                      const char* meaning, const char* net) {
  if (notation.net != nullptr) net = notation.net;
  return {
      name, width, notation.format, source, meaning, notation.fraction, net, notation.is_unreset};
}

}  // namespace row

/// One parameter of a design's RTL.
struct Parameter {
  const char* name;
  int value;
};

/// The fields of a record as an array of words, in the order of its table.
template <class Record>
using Words = std::array<Word, Record::size>;

/// Calls visit(member, i) for each field's pointer to member, in the order of the table.
template <class Record, class Visit>
constexpr void for_each_member(Visit visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (visit(Record::members()[I], I), ...); }
  (std::make_index_sequence<Record::size>{});
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
  for_each_member<Record>([&](auto member, std::size_t i) { words[i] = r.*member; });
  return words;
}

template <class Record>
constexpr Record from_words(const Words<Record>& words) {
  Record r;
  for_each_member<Record>([&](auto member, std::size_t i) { r.*member = words[i]; });
  return r;
}

}  // namespace cosim

#define COSIM_MEMBER(name, width, format, source, meaning) V name{};
#define COSIM_INDEX(name, width, format, source, meaning) index_##name,
#define COSIM_POINTER(name, width, format, source, meaning) &Self::name,
#define COSIM_FIELD(name, width, format, source, meaning) \
  ::cosim::row::field(#name, width, ::cosim::row::format, source, meaning, #name),
#define COSIM_FIELD_Q(name, width, format, source, meaning) \
  ::cosim::row::field(#name, width, ::cosim::row::format, source, meaning, #name "_q"),

/// Defines `template <class V> struct Record` with one member a row of TABLE, and its table as
/// data. Params is the type of p in the rows' widths.
#define COSIM_RECORD(Record, TABLE, Params) COSIM_RECORD_OF(Record, TABLE, COSIM_FIELD, Params)

/// The same of registers whose nets have the suffix _q in the RTL and not in the table.
#define COSIM_REGISTERS(Record, TABLE, Params) COSIM_RECORD_OF(Record, TABLE, COSIM_FIELD_Q, Params)

#define COSIM_RECORD_OF(Record, TABLE, ROW, Params)                                     \
  template <class V>                                                                    \
  struct Record {                                                                       \
    TABLE(COSIM_MEMBER)                                                                 \
    enum Index : std::size_t { TABLE(COSIM_INDEX) index_end };                          \
    static constexpr std::size_t size = index_end;                                      \
    static constexpr auto members() {                                                   \
      using Self = Record;                                                              \
      return std::array<V Self::*, size>{TABLE(COSIM_POINTER)};                         \
    }                                                                                   \
    static constexpr std::array<Field, size> fields([[maybe_unused]] const Params& p) { \
      return {TABLE(ROW)};                                                              \
    }                                                                                   \
    /* No parameter may have the name of a field. */                                    \
    friend Record select(Condition<V> when, const Record& then, const Record& other) {  \
      return select_record(when, then, other);                                          \
    }                                                                                   \
  }
