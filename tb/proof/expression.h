// Formulas of SMT-LIB 2 as shared trees, and the text that a solver reads.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace cosim::proof {

/// A term of a formula. Terms share their parts; a copy costs nothing.
class Expression {
 public:
  /// A symbol or a literal.
  Expression(std::string text, std::string sort)
      : Expression(std::move(text), std::move(sort), {}) {}
  /// An application: (text part part ...).
  Expression(std::string text, std::string sort, std::vector<Expression> parts)
      : node_(std::make_shared<const Node>(
            Node{std::move(text), std::move(sort), std::move(parts)})) {}

  const std::string& text() const { return node_->text; }
  const std::string& sort() const { return node_->sort; }
  const std::vector<Expression>& parts() const { return node_->parts; }
  const void* identity() const { return node_.get(); }

 private:
  struct Node {
    std::string text;
    std::string sort;
    std::vector<Expression> parts;
  };
  std::shared_ptr<const Node> node_;
};

inline const std::string boolean = "Bool";
std::string bit_vector(int width);

Expression negation(const Expression& a);
Expression conjunction(const Expression& a, const Expression& b);
Expression disjunction(const Expression& a, const Expression& b);
Expression equal(const Expression& a, const Expression& b);
Expression truth(bool value);

/// A script for a solver. Each application is defined once under a name of its own, in order and
/// without parameters: no let, no quantifier, no function.
class Script {
 public:
  explicit Script(const std::string& logic);

  /// A free symbol.
  Expression declare(const std::string& name, const std::string& sort);
  /// Gives `value` a name that a reader knows.
  Expression define(const std::string& name, const Expression& value);
  void assume(const Expression& condition);

  /// Asks the only question of a script: can all assumptions and `also` hold together?
  void ask(const Expression& also);
  /// Asks one of several.
  void ask_apart(const Expression& also);
  const std::string& text() const { return text_; }

 private:
  std::string name_of(const Expression& e);

  std::string text_;
  std::unordered_map<const void*, std::string> named_;
  std::unordered_map<std::string, std::string> same_;
  std::vector<Expression> kept_;  // so that no identity comes twice
};

}  // namespace cosim::proof
