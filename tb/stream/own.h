// A driver of a design's own for one of its streams, without its types.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "model/core/fields.h"

namespace cosim {

/// Of a stream that goes in.
class OwnGiver {
 public:
  virtual ~OwnGiver() = default;
  /// `words`: the cells of the transaction that may go in; null where there is none.
  virtual void drive(const std::span<const Word>* words, std::span<Word> pins) = 0;
  virtual bool took(std::span<const Word> pins) = 0;
  /// Once the design has settled, what it drives within the same clock; false: nothing else.
  virtual bool answer(std::span<const Word> /*pins*/, std::span<Word> /*drives*/) { return false; }
};

/// Of a stream that comes out.
class OwnTaker {
 public:
  virtual ~OwnTaker() = default;
  virtual void drive(bool ready, std::span<Word> pins) = 0;
  /// Whether a transaction has come; then `words` are its cells.
  virtual bool came(std::span<const Word> pins, std::vector<Word>& words) = 0;
  /// Once the design has settled, what it drives within the same clock; false: nothing else.
  virtual bool answer(std::span<const Word> /*pins*/, std::span<Word> /*drives*/) { return false; }
};

/// How they are made anew for each case, and the cells of their pins, named as the ports; nothing
/// where ports say all.
struct OwnDriver {
  std::vector<Field> drives, reads;
  std::function<std::unique_ptr<OwnGiver>()> giver;
  std::function<std::unique_ptr<OwnTaker>()> taker;

  bool is_there() const { return giver || taker; }
};

}  // namespace cosim
