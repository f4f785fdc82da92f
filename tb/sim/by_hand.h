// RTL and model in lockstep as a test by hand sees them: this, the design and a few headers of the
// standard library are all that such a test reads.
#pragma once

#include <vector>

#include "model/core/fields.h"

namespace cosim {

/// Words in the order of the bench's fields. Both were just reset.
class AnyByHand {
 public:
  virtual ~AnyByHand() = default;
  /// The first rule of the design that the inputs break now, a sentence; null where they break
  /// none.
  virtual const char* broken_rule(const std::vector<Word>& inputs) const = 0;
  /// One clock; false where RTL and model differ.
  virtual bool clock(const std::vector<Word>& inputs) = 0;
  /// Codes: the model's outputs on the last clock; all 0 before the first.
  virtual std::vector<Word> outputs() const = 0;
  /// Numbers: the model's state before the next clock.
  virtual std::vector<Word> state() const = 0;
};

}  // namespace cosim
