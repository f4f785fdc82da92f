// The cells that a shape has of a record: what people and files see. A record of a design with
// arrays has more, those of its arrays at their full size.
#pragma once

#include <cstddef>
#include <vector>

#include "model/core/fields.h"

namespace cosim {

template <class Record>
class Cells {
 public:
  template <class Params>
  explicit Cells(const Params& p) {
    const auto all = Record::fields(p);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].width == 0) continue;
      fields_.push_back(all[i]);
      places_.push_back(i);
    }
  }

  /// In the order of the table.
  const std::vector<Field>& fields() const { return fields_; }
  /// What they hold in a record.
  std::vector<Word> words(const Record& record) const {
    const Words<Record> all = to_words(record);
    std::vector<Word> words;
    words.reserve(places_.size());
    for (const std::size_t place : places_) words.push_back(all[place]);
    return words;
  }
  /// The record in which they hold `words`, one a field.
  Record record(const std::vector<Word>& words) const {
    Words<Record> all{};
    for (std::size_t i = 0; i < places_.size(); ++i) all[places_[i]] = words[i];
    return from_words<Record>(all);
  }

 private:
  std::vector<Field> fields_;
  std::vector<std::size_t> places_;  // in the record's words
};

}  // namespace cosim
