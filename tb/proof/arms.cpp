// A next value is mostly a choice of choices. Its arms, what it comes to at the ends of them, are
// compared each with each of the other's, under the conditions of both (cofactors). Two sums that
// stand in an equation then lose what they have in common when a solver's rewriting sees them,
// before anything is made gates; below a choice they would not.
#include "tb/proof/arms.h"

#include <utility>
#include <vector>

namespace cosim::proof {
namespace {

constexpr std::size_t kMostArms = 16;  // arms of a code

struct Arm {
  Expression when, code;
};

std::optional<Choice> choice_of(const Expression& code, const Rtl& rtl) {
  const auto& parts = code.parts();
  if (parts.empty()) return rtl.choice(code.text());
  if (code.text() == "ite") return Choice{parts[0], parts[1], parts[2]};
  // Bits of a code, or a longer one.
  if (parts.size() != 1 || !code.text().starts_with("(_ ")) return {};
  auto inner = choice_of(parts[0], rtl);
  if (!inner) return {};
  const auto same = [&](const Expression& arm) {
    return Expression(code.text(), code.sort(), {arm});
  };
  return Choice{inner->condition, same(inner->then), same(inner->otherwise)};
}

std::vector<Arm> arms_of(const Expression& code, const Rtl& rtl) {
  std::vector<Arm> all{{truth(true), code}};
  for (std::size_t i = 0; i < all.size() && all.size() < kMostArms;) {
    const auto choice = choice_of(all[i].code, rtl);
    if (!choice) {
      ++i;
      continue;
    }
    const Expression when = all[i].when;
    all[i] = {conjunction(when, choice->condition), choice->then};
    all.push_back({conjunction(when, negation(choice->condition)), choice->otherwise});
  }
  return all;
}

}  // namespace

Expression differ(const Expression& a, const Expression& b, const Rtl& rtl) {
  const auto of_a = arms_of(a, rtl), of_b = arms_of(b, rtl);
  Expression any = truth(false);
  for (const Arm& x : of_a) {
    Expression from_x = truth(false);
    for (const Arm& y : of_b) {
      from_x = disjunction(from_x, conjunction(y.when, negation(equal(x.code, y.code))));
    }
    any = disjunction(any, conjunction(x.when, from_x));
  }
  return any;
}

}  // namespace cosim::proof
