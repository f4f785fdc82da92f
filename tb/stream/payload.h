// Transactions of one stream, between the records of a model and the codes at the ports.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "model/core/record.h"
#include "tb/lockstep/cells.h"
#include "tb/stream/sequence.h"

namespace cosim::detail {

template <class Record>
class Payload {
 public:
  template <class Params>
  explicit Payload(const Params& p) : fields_(Record::fields(p)) {
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      if (fields_[i].width != 0) places_.push_back(i);
    }
  }

  Record record(std::span<const Word> words) const {
    Words<Record> all{};
    for (std::size_t i = 0; i < places_.size(); ++i) {
      all[places_[i]] = units_of(fields_[places_[i]], words[i]);
    }
    return from_words<Record>(all);
  }
  std::vector<Record> records(const Sequence& sequence) const {
    std::vector<Record> all;
    all.reserve(sequence.size());
    for (std::size_t n = 0; n < sequence.size(); ++n) all.push_back(record(sequence[n]));
    return all;
  }
  /// The records in place of what `all` holds. InputError "TITLE: ..." where a value has no code.
  void sequence(const std::vector<Record>& records, const std::string& title,
                const std::string& stream, Sequence& all) const {
    all.clear();
    std::vector<Word> words(places_.size());
    for (const Record& r : records) {
      const Words<Record> values = to_words(r);
      for (std::size_t i = 0; i < places_.size(); ++i) {
        const Field& f = fields_[places_[i]];
        words[i] = values[places_[i]];
        if (!is_state(f, words[i])) {
          throw InputError(
              fmt::format("{}: the model gives {} for {} of stream {}, which has {} "
                          "bits",
                          title, words[i], label_of(f), stream, f.width));
        }
        words[i] = f.format == Format::ones_complement ? to_ones_complement(words[i], f.width)
                                                       : low_bits(words[i], f.width);
      }
      all.push(words);
    }
  }
  std::size_t cells() const { return places_.size(); }

 private:
  std::array<Field, Record::size> fields_;
  std::vector<std::size_t> places_;  // of the cells that the shape has
};

}  // namespace cosim::detail
