// The records of a design whose model is a struct, by the names of a test's own structs of Words.
#pragma once

#include <bit>

#include "model/core/fields.h"

namespace cosim::test {

template <class Named, class Record>
constexpr Named named(const Record& record) {
  return std::bit_cast<Named>(to_words(record));
}
template <class Record, class Named>
constexpr Record record_of(const Named& named) {
  return from_words<Record>(std::bit_cast<Words<Record>>(named));
}

}  // namespace cosim::test
