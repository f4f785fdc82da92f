// A struct of a model as the codes of its cells, and back.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "model/clocked/asked.h"
#include "tb/stream/sequence.h"

namespace cosim::detail {

/// Of a struct T: a transaction, or the pins of a driver.
template <class T>
struct Codes {
  using Table = clocked::RecordTable<T>;
  using Record = clocked::ModelRecord<Word, Table>;

  static const auto& fields() { return Table::fields({}); }
  /// `words`: one a cell.
  static void put(const T& object, std::span<Word> words) {
    const auto codes = to_words(clocked::codes_of<Record>(object));
    std::copy(codes.begin(), codes.end(), words.begin());
  }
  static T object(std::span<const Word> words) {
    Words<Record> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = units_of(fields()[i], words[i]);
    return clocked::object_of<T>(from_words<Record>(numbers));
  }
  static std::vector<T> objects(const Sequence& sequence) {
    std::vector<T> all;
    all.reserve(sequence.size());
    for (std::size_t n = 0; n < sequence.size(); ++n) all.push_back(object(sequence[n]));
    return all;
  }
};

}  // namespace cosim::detail
