// What an exported model is asked for, and the records that go in and come out.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/clocked/records.h"

namespace cosim::clocked {

/// Runs an exported model on a value type that is a symbol: give() and conditions(), of bits of
/// gates in tb/nets/exported.h.
template <class V>
struct SymbolsOf;

/// A value, and the field that it is one of.
template <class V>
struct SymbolCell {
  Field field;
  V value;
};
/// What an exported model is asked for a clock of.
template <class V>
struct Asked {
  std::string file;                           ///< without .btor2
  std::vector<SymbolCell<V>> inputs, states;  ///< in the file's order
};
/// The cells of a record that its shape has.
template <class V, class Table>
std::vector<SymbolCell<V>> cells_of(const Shape& shape, const ModelRecord<V, Table>& record) {
  std::vector<SymbolCell<V>> all;
  const auto fields = Table::fields(shape);
  cosim::for_each_cell<ModelRecord<V, Table>>([&](auto cell, std::size_t i) {
    if (fields[i].width != 0) all.push_back({fields[i], cell(record)});
  });
  return all;
}
/// A record of what it gives in a section of the file (export.h): of "next" numbers, else codes.
template <class Record, class V>
Record answer(const Shape& shape, const Asked<V>& asked, const char* section) {
  std::vector<SymbolCell<V>> wanted = cells_of(shape, Record{});
  SymbolsOf<V>::give(asked, section, wanted);
  Record r{};
  const auto fields = Record::Table::fields(shape);
  std::size_t at = 0;
  cosim::for_each_cell<Record>([&](auto cell, std::size_t i) {
    if (fields[i].width != 0) cell(r) = wanted[at++].value;
  });
  return r;
}
/// The object that a record is.
template <class T, class Record>
constexpr T object_of(const Record& record) {
  T object = zero<T>();
  take_record(record, object);
  return object;
}

}  // namespace cosim::clocked
