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

  std::size_t size() const { return size_; }
  std::size_t cells() const { return cells_; }
  std::span<const Word> operator[](std::size_t i) const {
    return std::span(words_).subspan(i * cells_, cells_);
  }
  /// `words`: one a cell.
  void push(std::span<const Word> words) {
    for (const Word w : words) words_.push_back(w);
    ++size_;
  }
  /// Takes all of them out.
  void clear() {
    words_.clear();
    size_ = 0;
  }

 private:
  std::size_t cells_;  // of a transaction, >= 1
  std::size_t size_ = 0;
  std::vector<Word> words_;
};

}  // namespace cosim
