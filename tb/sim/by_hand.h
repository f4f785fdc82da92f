// RTL and model in lockstep as a test by hand sees them: this, the design and a few headers of the
// standard library are all that such a test reads.
#pragma once

#include <vector>

#include "model/core/fields.h"

namespace cosim {

/// Of whatever design, as words in the order of the bench's tables. Both were just reset.
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

/// The same as records.
template <class Design>
class ByHand : public AnyByHand {
 public:
  using AnyByHand::broken_rule, AnyByHand::clock;
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using State = typename Design::template State<Word>;

  /// The first rule of the design that the inputs break now, a sentence; null where they break
  /// none.
  virtual const char* broken_rule(const Inputs& in) const = 0;
  /// One clock; false where RTL and model differ.
  virtual bool clock(const Inputs& in) = 0;
  /// The model's outputs on the last clock; all 0 before the first.
  virtual const Outputs& out() const = 0;
  /// The model's state before the next clock.
  virtual const State& now() const = 0;
};

}  // namespace cosim
