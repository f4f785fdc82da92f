#include "tb/proof/integer.h"

#include <fmt/core.h>

namespace cosim::proof {
namespace {

const std::string integer_sort = "Int";

Integer made(const char* head, const Integer& a, const Integer& b) {
  return Integer(Expression(head, integer_sort, {a.expression(), b.expression()}));
}
Truth compared(const char* head, const Integer& a, const Integer& b) {
  return Truth(Expression(head, boolean, {a.expression(), b.expression()}));
}
Integer power_of_two(int n) { return Integer(cosim::shift_left(1, n)); }

}  // namespace

Integer::Integer(Word known)
    : known_(known),
      expression_(known < 0 ? fmt::format("(- {})", -known) : fmt::format("{}", known),
                  integer_sort) {}

Integer operator+(const Integer& a, const Integer& b) {
  if (a.known() && b.known()) return Integer(*a.known() + *b.known());
  return made("+", a, b);
}
Integer operator-(const Integer& a, const Integer& b) {
  if (a.known() && b.known()) return Integer(*a.known() - *b.known());
  return made("-", a, b);
}
Integer operator*(const Integer& a, const Integer& b) {
  if (a.known() && b.known()) return Integer(*a.known() * *b.known());
  return made("*", a, b);
}
Truth operator<(const Integer& a, const Integer& b) {
  if (a.known() && b.known()) return *a.known() < *b.known();
  return compared("<", a, b);
}
Truth operator==(const Integer& a, const Integer& b) {
  if (a.known() && b.known()) return *a.known() == *b.known();
  return compared("=", a, b);
}
Truth operator>(const Integer& a, const Integer& b) { return b < a; }
Truth operator<=(const Integer& a, const Integer& b) { return !(b < a); }
Truth operator>=(const Integer& a, const Integer& b) { return !(a < b); }
Truth implies(const Truth& a, const Truth& b) { return b | !a; }

Integer low_bits(const Integer& v, int width) {
  if (v.known()) return Integer(cosim::low_bits(*v.known(), width));
  return made("mod", v, power_of_two(width));
}
Truth bit(const Integer& v, int i) {
  if (v.known()) return cosim::bit(*v.known(), i);
  return low_bits(shift_right(v, i), 1) == Integer(1);
}
Integer shift_left(const Integer& v, int n) { return power_of_two(n) * v; }
Integer shift_right(const Integer& v, int n) {
  if (v.known()) return Integer(cosim::shift_right(*v.known(), n));
  return n == 0 ? v : made("div", v, power_of_two(n));  // towards minus infinity
}
Integer select(const Truth& c, const Integer& a, const Integer& b) {
  if (c.known()) return *c.known() ? a : b;
  return Integer(Expression("ite", integer_sort, {c.expression(), a.expression(), b.expression()}));
}

}  // namespace cosim::proof
