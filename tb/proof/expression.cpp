#include "tb/proof/expression.h"

#include <fmt/core.h>

namespace cosim::proof {
namespace {

std::string definition(const std::string& name, const std::string& sort, const std::string& term) {
  return fmt::format("(define-fun {} () {} {})\n", name, sort, term);
}

}  // namespace

std::string bit_vector(int width) { return fmt::format("(_ BitVec {})", width); }

Expression truth(bool value) { return {value ? "true" : "false", boolean}; }
Expression negation(const Expression& a) { return {"not", boolean, {a}}; }
Expression conjunction(const Expression& a, const Expression& b) {
  return {"and", boolean, {a, b}};
}
Expression disjunction(const Expression& a, const Expression& b) { return {"or", boolean, {a, b}}; }
Expression equal(const Expression& a, const Expression& b) { return {"=", boolean, {a, b}}; }

Script::Script(const std::string& logic)
    : text_(fmt::format("(set-option :produce-models true)\n(set-logic {})\n", logic)) {}

Expression Script::declare(const std::string& name, const std::string& sort) {
  text_ += fmt::format("(declare-const {} {})\n", name, sort);
  return {name, sort};
}

Expression Script::define(const std::string& name, const Expression& value) {
  const std::string text = name_of(value);
  text_ += definition(name, value.sort(), text);
  return {name, value.sort()};
}

void Script::assume(const Expression& condition) {
  const std::string text = name_of(condition);
  text_ += fmt::format("(assert {})\n", text);
}

void Script::ask(const Expression& also) {
  assume(also);
  text_ += "(check-sat)\n";
}

void Script::ask_apart(const Expression& also) {
  const std::string name = name_of(also);
  text_ += fmt::format("(push 1)\n(assert {})\n(check-sat)\n(pop 1)\n", name);
}

std::string Script::name_of(const Expression& e) {
  if (e.parts().empty()) return e.text();
  if (const auto found = named_.find(e.identity()); found != named_.end()) return found->second;
  std::string text = '(' + e.text();
  for (const Expression& part : e.parts()) text += ' ' + name_of(part);
  text += ')';
  auto [same, is_new] = same_.try_emplace(text, fmt::format("t{}", same_.size()));
  if (is_new) text_ += definition(same->second, e.sort(), text);
  named_.emplace(e.identity(), same->second);
  kept_.push_back(e);
  return same->second;
}

}  // namespace cosim::proof
