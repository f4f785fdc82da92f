// Unbounded integers as symbols, written as SMT-LIB 2: a model run on Integer gives its formula for
// registers that never overflow. That a register of some width does not overflow is a theorem of
// its own. What is of bits alone, or wraps, has no meaning here: a model that uses it does not
// compile on Integer.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/core/value.h"

namespace cosim::proof {

/// A term of a formula. Terms share their parts; a copy costs nothing.
class Expression {
 public:
  /// An application, (text part part ...), or without parts a symbol or a literal. `sort`: "Bool"
  /// or "Int".
  Expression(std::string text, const char* sort, std::vector<Expression> parts = {})
      : node_(std::make_shared<const Node>(Node{std::move(text), sort, std::move(parts)})) {}

  const std::string& text() const { return node_->text; }
  const char* sort() const { return node_->sort; }
  const std::vector<Expression>& parts() const { return node_->parts; }
  const void* identity() const { return node_.get(); }

 private:
  struct Node {
    std::string text;
    const char* sort;
    std::vector<Expression> parts;
  };
  std::shared_ptr<const Node> node_;
};

/// A condition on symbols. If its value is known without a solver it stays a plain truth value.
class Truth {
 public:
  Truth(bool known);  // NOLINT: a truth value is one
  explicit Truth(Expression e) : expression_(std::move(e)) {}

  const std::optional<bool>& known() const { return known_; }
  const Expression& expression() const { return expression_; }

 private:
  std::optional<bool> known_;
  Expression expression_;
};

Truth operator!(const Truth& a);
Truth operator&(const Truth& a, const Truth& b);
Truth operator|(const Truth& a, const Truth& b);
Truth operator^(const Truth& a, const Truth& b);
/// a implies b.
Truth implies(const Truth& a, const Truth& b);

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
Integer operator*(const Integer& a, const Integer& b);
Truth operator<(const Integer& a, const Integer& b);
Truth operator>(const Integer& a, const Integer& b);
Truth operator<=(const Integer& a, const Integer& b);
Truth operator>=(const Integer& a, const Integer& b);
Truth operator==(const Integer& a, const Integer& b);
Integer low_bits(const Integer& v, int width);
Truth bit(const Integer& v, int i);
Integer shift_left(const Integer& v, int n);
Integer shift_right(const Integer& v, int n);
Integer select(const Truth& c, const Integer& a, const Integer& b);

/// A script for z3. Each application is defined once under a name of its own, in order and without
/// parameters: no let, no quantifier, no function.
class Script {
 public:
  /// A free integer.
  Integer integer(const std::string& name);
  void assume(const Truth& condition);
  /// Asks its only question: can all assumptions and `also` hold together? Gives the text.
  std::string asked(const Truth& also) const;

 private:
  std::string name_of(const Expression& e);

  std::string text_ = "(set-logic QF_NIA)\n";
  std::unordered_map<const void*, std::string> named_;
  std::unordered_map<std::string, std::string> same_;
  std::vector<Expression> kept_;  // so that no identity comes twice
};

}  // namespace cosim::proof
