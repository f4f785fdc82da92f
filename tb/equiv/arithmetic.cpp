#include "tb/equiv/arithmetic.h"

#include <algorithm>

namespace cosim::equiv {

using proof::Aig;
using Lit = Aig::Lit;

Lits Arithmetic::extended(Lits a, std::size_t width, bool is_signed) {
  a.resize(width, is_signed && !a.empty() ? a.back() : 0);
  return a;
}

Lits Arithmetic::inverted(Lits a) {
  for (Lit& bit : a) bit = Aig::inverted(bit);
  return a;
}

Lit Arithmetic::all(const Lits& a) {
  Lit result = 1;
  for (const Lit bit : a) result = graph_.and_of(result, bit);
  return result;
}

Lit Arithmetic::parity(const Lits& a) {
  Lit result = 0;
  for (const Lit bit : a) result = graph_.xor_of(result, bit);
  return result;
}

Lit Arithmetic::equal(const Lits& a, const Lits& b) {
  Lit result = 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result = graph_.and_of(result, Aig::inverted(graph_.xor_of(a[i], b[i])));
  }
  return result;
}

Lit Arithmetic::less(const Lits& a, const Lits& b, bool is_signed) {
  Lit result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool is_sign = is_signed && i + 1 == a.size();
    const Lit differs = graph_.xor_of(a[i], b[i]);
    result = graph_.choose(differs, is_sign ? a[i] : b[i], result);
  }
  return result;
}

Lits Arithmetic::choose(Lit condition, const Lits& then, const Lits& otherwise) {
  Lits result(then.size());
  for (std::size_t i = 0; i < then.size(); ++i) {
    result[i] = then[i] == otherwise[i] ? then[i] : graph_.choose(condition, then[i], otherwise[i]);
  }
  return result;
}

Lits Arithmetic::sum(const Lits& a, const Lits& b, Lit carry) {
  Lits result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Lit half = graph_.xor_of(a[i], b[i]);
    result[i] = graph_.xor_of(half, carry);
    if (i + 1 < a.size()) {
      carry = graph_.or_of(graph_.and_of(a[i], b[i]), graph_.and_of(half, carry));
    }
  }
  return result;
}

Lits Arithmetic::product(const Lits& a, const Lits& b) {
  Lits result(a.size(), 0);
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (b[i] == 0) continue;
    Lits row(a.size(), 0);
    for (std::size_t j = i; j < a.size(); ++j) row[j] = graph_.and_of(a[j - i], b[i]);
    result = sum(result, row);
  }
  return result;
}

std::pair<Lits, Lits> Arithmetic::divided(const Lits& a, const Lits& b) {
  const std::size_t width = a.size();
  const Lits divisor = extended(b, width + 1, false);
  Lits rest(width + 1, 0), quotient(width, 0);
  for (std::size_t i = width; i-- > 0;) {
    rest.insert(rest.begin(), a[i]);
    rest.pop_back();
    quotient[i] = Aig::inverted(less(rest, divisor, false));
    rest = choose(quotient[i], difference(rest, divisor), rest);
  }
  rest.pop_back();
  return {quotient, rest};
}

std::pair<Lits, Lits> Arithmetic::divided(const Lits& a, const Lits& b, bool is_signed,
                                          bool floors) {
  if (!is_signed) return divided(a, b);
  const Lit minus_a = a.back(), minus_b = b.back(), apart = graph_.xor_of(minus_a, minus_b);
  auto [quotient, rest] = divided(choose(minus_a, negated(a), a), choose(minus_b, negated(b), b));
  quotient = choose(apart, negated(quotient), quotient);
  rest = choose(minus_a, negated(rest), rest);
  if (floors) {
    const Lit rounds = graph_.and_of(apart, any(rest));
    quotient = sum(quotient, Lits(a.size(), rounds));
    rest = choose(rounds, sum(rest, b), rest);
  }
  return {quotient, rest};
}

Lits Arithmetic::left(Lits a, const Lits& amount, Lit fill) {
  std::reverse(a.begin(), a.end());
  a = right(std::move(a), amount, fill);
  std::reverse(a.begin(), a.end());
  return a;
}

Lits Arithmetic::right(Lits a, const Lits& amount, Lit fill) {
  const std::size_t width = a.size();
  for (std::size_t bit = 0; bit < amount.size(); ++bit) {
    if (amount[bit] == 0) continue;
    const bool is_beyond = bit >= 32 || (std::size_t{1} << bit) >= width;
    const std::size_t by = is_beyond ? width : std::size_t{1} << bit;
    Lits moved(width, fill);
    std::copy(a.begin() + static_cast<std::ptrdiff_t>(by), a.end(), moved.begin());
    a = choose(amount[bit], moved, a);
  }
  return a;
}

}  // namespace cosim::equiv
