// Unbounded integers as symbols: a model run on Integer gives its formula for registers that never
// overflow. That a register of some width does not overflow is a theorem of its own. What is of
// bits alone, or wraps, has no meaning here: a model that uses it does not compile on Integer.
#pragma once

#include <optional>

#include "tb/proof/bits.h"

namespace cosim::proof {

class Integer {
 public:
  Integer() : Integer(0) {}
  explicit Integer(Word known);
  explicit Integer(Expression e) : expression_(std::move(e)) {}

  const std::optional<Word>& known() const { return known_; }
  const Expression& expression() const { return expression_; }

 private:
  std::optional<Word> known_;
  Expression expression_;
};

Integer operator+(const Integer& a, const Integer& b);
Integer operator-(const Integer& a, const Integer& b);
Truth operator<(const Integer& a, const Integer& b);
Truth operator>(const Integer& a, const Integer& b);
Truth operator==(const Integer& a, const Integer& b);
Integer low_bits(const Integer& v, int width);
Truth bit(const Integer& v, int i);
Integer shift_left(const Integer& v, int n);
Integer shift_right(const Integer& v, int n);
Integer select(const Truth& c, const Integer& a, const Integer& b);

Integer operator*(const Integer& a, const Integer& b);

// For theorems only.
Truth operator<=(const Integer& a, const Integer& b);
Truth operator>=(const Integer& a, const Integer& b);
/// a implies b.
Truth implies(const Truth& a, const Truth& b);

}  // namespace cosim::proof
