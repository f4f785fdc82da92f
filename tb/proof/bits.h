// The machine word of the golden models as a symbol: a model run on BitVector instead of Word gives
// the formula of what it does.
#pragma once

#include <optional>

#include "model/core/value.h"
#include "tb/proof/expression.h"

namespace cosim::proof {

/// A condition on symbols. If its value is known without a solver it stays a plain truth value.
class Truth : public SymbolicCondition {
 public:
  Truth(bool known) : known_(known), expression_(truth(known)) {}  // NOLINT: a truth value is one
  explicit Truth(Expression e) : expression_(std::move(e)) {}

  const std::optional<bool>& known() const { return known_; }
  const Expression& expression() const { return expression_; }

 private:
  std::optional<bool> known_;
  Expression expression_;
};

inline const Expression& fact_of(const Truth& t) { return t.expression(); }

Truth operator!(const Truth& a);
Truth operator&(const Truth& a, const Truth& b);
Truth operator|(const Truth& a, const Truth& b);
Truth operator^(const Truth& a, const Truth& b);

/// A Word within known bounds. Its expression is a two's complement code with only as many bits as
/// the bounds need, because each bit costs the solver work. If the bounds would leave 64 bits there
/// are none, and the value wraps as a Word does.
class BitVector : public Symbolic {
 public:
  BitVector() : BitVector(0) {}
  BitVector(Word known);      // NOLINT: a number is one
  BitVector(const Truth& t);  // NOLINT: 1 or 0
  /// A code of `width` bits as the number it is without a sign, or in two's complement.
  static BitVector unsigned_code(const Expression& code, int width);
  static BitVector signed_code(const Expression& code, int width);
  /// The number of least..most whose code is `e`, or the lower bits of `e`.
  BitVector(const Expression& e, int width, Word least, Word most, int zeros = 0);

  Word least() const { return least_; }
  Word most() const { return most_; }
  std::optional<Word> known() const;
  int width() const { return width_; }
  /// How many low bits are known to be zero.
  int zeros() const { return zeros_; }
  /// The lower `width` bits, of the number in two's complement.
  Expression code(int width) const;

 private:
  Word least_;
  Word most_;
  int width_;
  int zeros_ = 0;
  Expression expression_;
};

/// `width` bits of a code, from bit `low` up.
Expression cut(const Expression& code, int low, int width);

BitVector operator+(const BitVector& a, const BitVector& b);
BitVector operator-(const BitVector& a, const BitVector& b);
BitVector operator*(const BitVector& a, const BitVector& b);
BitVector operator&(const BitVector& a, const BitVector& b);
BitVector operator|(const BitVector& a, const BitVector& b);
BitVector operator^(const BitVector& a, const BitVector& b);
Truth operator<(const BitVector& a, const BitVector& b);
Truth operator>(const BitVector& a, const BitVector& b);
Truth operator==(const BitVector& a, const BitVector& b);
BitVector low_bits(const BitVector& v, int width);
Truth bit(const BitVector& v, int i);
BitVector shift_left(const BitVector& v, int n);
BitVector shift_right(const BitVector& v, int n);
BitVector shift_left(const BitVector& v, const BitVector& n);
BitVector shift_right(const BitVector& v, const BitVector& n);
BitVector select(const Truth& c, const BitVector& a, const BitVector& b);

// The operators wrap already.
inline BitVector add(const BitVector& a, const BitVector& b) { return a + b; }
inline BitVector subtract(const BitVector& a, const BitVector& b) { return a - b; }
inline BitVector multiply(const BitVector& a, const BitVector& b) { return a * b; }

}  // namespace cosim::proof
