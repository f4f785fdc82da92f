// Transactions of one stream, one after the other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/core/value.h"

namespace cosim {

/// Each is the codes of its cells.
class Sequence {
 public:
  explicit Sequence(std::size_t cells = 1) : cells_(cells) {}

  std::size_t size() const { return words_.size() / cells_; }
  std::size_t cells() const { return cells_; }
  std::span<const Word> operator[](std::size_t i) const {
    return std::span(words_).subspan(i * cells_, cells_);
  }
  /// `words`: one a cell.
  void push(std::span<const Word> words) {
    words_.insert(words_.end(), words.begin(), words.end());
  }
  /// The first `n` of them.
  Sequence first(std::size_t n) const {
    Sequence some(cells_);
    some.push(std::span(words_).first(n * cells_));
    return some;
  }

 private:
  std::size_t cells_;  // of a transaction, >= 1
  std::vector<Word> words_;
};

}  // namespace cosim
