#include "tb/proof/integer.h"

#include <fmt/core.h>

namespace cosim::proof {
namespace {

constexpr const char *kTruth = "Bool", *kInteger = "Int";

template <class Result, class Operand>
Result applied(const char* head, const char* sort, const Operand& a, const Operand& b) {
  return Result(Expression(head, sort, {a.expression(), b.expression()}));
}
Integer power_of_two(int n) { return Integer(cosim::shift_left(1, n)); }

}  // namespace

Truth::Truth(bool known) : known_(known), expression_(known ? "true" : "false", kTruth) {}

Truth operator!(const Truth& a) {
  if (a.known()) return !*a.known();
  return Truth(Expression("not", kTruth, {a.expression()}));
}
Truth operator&(const Truth& a, const Truth& b) {
  if (a.known()) return *a.known() ? b : a;
  if (b.known()) return *b.known() ? a : b;
  return applied<Truth>("and", kTruth, a, b);
}
Truth operator|(const Truth& a, const Truth& b) {
  if (a.known()) return *a.known() ? a : b;
  if (b.known()) return *b.known() ? b : a;
  return applied<Truth>("or", kTruth, a, b);
}
Truth operator^(const Truth& a, const Truth& b) {
  if (a.known()) return *a.known() ? !b : b;
  if (b.known()) return *b.known() ? !a : a;
  return applied<Truth>("xor", kTruth, a, b);
}
Truth implies(const Truth& a, const Truth& b) { return b | !a; }

Integer::Integer(Word known)
    : known_(known),
      expression_(known < 0 ? fmt::format("(- {})", -known) : fmt::format("{}", known), kInteger) {}

Integer operator+(const Integer& a, const Integer& b) {
  if (a.known() && b.known()) return Integer(*a.known() + *b.known());
  return applied<Integer>("+", kInteger, a, b);
}
Integer operator-(const Integer& a, const Integer& b) {
  if (a.known() && b.known()) return Integer(*a.known() - *b.known());
  return applied<Integer>("-", kInteger, a, b);
}
Integer operator*(const Integer& a, const Integer& b) {
  if (a.known() && b.known()) return Integer(*a.known() * *b.known());
  return applied<Integer>("*", kInteger, a, b);
}
Truth operator<(const Integer& a, const Integer& b) {
  if (a.known() && b.known()) return *a.known() < *b.known();
  return applied<Truth>("<", kTruth, a, b);
}
Truth operator==(const Integer& a, const Integer& b) {
  if (a.known() && b.known()) return *a.known() == *b.known();
  return applied<Truth>("=", kTruth, a, b);
}
Truth operator>(const Integer& a, const Integer& b) { return b < a; }
Truth operator<=(const Integer& a, const Integer& b) { return !(b < a); }
Truth operator>=(const Integer& a, const Integer& b) { return !(a < b); }

Integer low_bits(const Integer& v, int width) {
  if (v.known()) return Integer(cosim::low_bits(*v.known(), width));
  return applied<Integer>("mod", kInteger, v, power_of_two(width));
}
Truth bit(const Integer& v, int i) {
  if (v.known()) return cosim::bit(*v.known(), i);
  return low_bits(shift_right(v, i), 1) == Integer(1);
}
Integer shift_left(const Integer& v, int n) { return power_of_two(n) * v; }
Integer shift_right(const Integer& v, int n) {
  if (v.known()) return Integer(cosim::shift_right(*v.known(), n));
  return n == 0 ? v : applied<Integer>("div", kInteger, v, power_of_two(n));  // rounds down
}
Integer select(const Truth& c, const Integer& a, const Integer& b) {
  if (c.known()) return *c.known() ? a : b;
  return Integer(Expression("ite", kInteger, {c.expression(), a.expression(), b.expression()}));
}

Integer Script::integer(const std::string& name) {
  text_ += fmt::format("(declare-const {} {})\n", name, kInteger);
  return Integer(Expression(name, kInteger));
}

void Script::assume(const Truth& condition) {
  const std::string name = name_of(condition.expression());
  text_ += fmt::format("(assert {})\n", name);
}

std::string Script::asked(const Truth& also) const {
  Script script = *this;
  script.assume(also);
  return script.text_ + "(check-sat)\n";
}

std::string Script::name_of(const Expression& e) {
  if (e.parts().empty()) return e.text();
  if (const auto found = named_.find(e.identity()); found != named_.end()) return found->second;
  std::string text = '(' + e.text();
  for (const Expression& part : e.parts()) text += ' ' + name_of(part);
  text += ')';
  auto [same, is_new] = same_.try_emplace(text, fmt::format("t{}", same_.size()));
  if (is_new) text_ += fmt::format("(define-fun {} () {} {})\n", same->second, e.sort(), text);
  named_.emplace(e.identity(), same->second);
  kept_.push_back(e);
  return same->second;
}

}  // namespace cosim::proof
