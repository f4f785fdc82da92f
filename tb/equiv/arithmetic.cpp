#include "tb/equiv/cells.h"

#include <algorithm>

namespace cosim::equiv {

Bits Arithmetic::extended(Bits a, std::size_t width, bool is_signed) {
  a.resize(width, is_signed && !a.empty() ? a.back() : no);
  return a;
}

Bits Arithmetic::inverted(Bits a) {
  for (Bit& bit : a) bit = !bit;
  return a;
}

Bit Arithmetic::all(const Bits& a) {
  Bit result = yes;
  for (const Bit bit : a) result = graph_.and_of(result, bit);
  return result;
}

Bit Arithmetic::parity(const Bits& a) {
  Bit result = no;
  for (const Bit bit : a) result = graph_.xor_of(result, bit);
  return result;
}

Bit Arithmetic::equal(const Bits& a, const Bits& b) {
  Bit result = yes;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result = graph_.and_of(result, !graph_.xor_of(a[i], b[i]));
  }
  return result;
}

Bit Arithmetic::less(const Bits& a, const Bits& b, bool is_signed) {
  Bit result = no;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool is_sign = is_signed && i + 1 == a.size();
    const Bit differs = graph_.xor_of(a[i], b[i]);
    result = graph_.mux(differs, is_sign ? a[i] : b[i], result);
  }
  return result;
}

Bits Arithmetic::choose(Bit condition, const Bits& then, const Bits& otherwise) {
  Bits result(then.size());
  for (std::size_t i = 0; i < then.size(); ++i) {
    result[i] = then[i] == otherwise[i] ? then[i] : graph_.mux(condition, then[i], otherwise[i]);
  }
  return result;
}

Bits Arithmetic::sum(const Bits& a, const Bits& b, Bit carry) {
  Bits result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Bit half = graph_.xor_of(a[i], b[i]);
    result[i] = graph_.xor_of(half, carry);
    if (i + 1 < a.size()) carry = graph_.mux(half, carry, a[i]);
  }
  return result;
}

Bits Arithmetic::product(const Bits& a, const Bits& b) {
  Bits result(a.size(), no);
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (b[i] == no) continue;
    Bits row(a.size(), no);
    for (std::size_t j = i; j < a.size(); ++j) row[j] = graph_.and_of(a[j - i], b[i]);
    result = sum(result, row);
  }
  return result;
}

std::pair<Bits, Bits> Arithmetic::divided(const Bits& a, const Bits& b) {
  const std::size_t width = a.size();
  const Bits divisor = extended(b, width + 1, false);
  Bits rest(width + 1, no), quotient(width, no);
  for (std::size_t i = width; i-- > 0;) {
    rest.insert(rest.begin(), a[i]);
    rest.pop_back();
    quotient[i] = !less(rest, divisor, false);
    rest = choose(quotient[i], difference(rest, divisor), rest);
  }
  rest.pop_back();
  return {quotient, rest};
}

std::pair<Bits, Bits> Arithmetic::divided(const Bits& a, const Bits& b, bool is_signed,
                                          bool floors) {
  if (!is_signed) return divided(a, b);
  const Bit minus_a = a.back(), minus_b = b.back(), apart = graph_.xor_of(minus_a, minus_b);
  auto [quotient, rest] = divided(choose(minus_a, negated(a), a), choose(minus_b, negated(b), b));
  quotient = choose(apart, negated(quotient), quotient);
  rest = choose(minus_a, negated(rest), rest);
  if (floors) {
    const Bit rounds = graph_.and_of(apart, any(rest));
    quotient = sum(quotient, Bits(a.size(), rounds));
    rest = choose(rounds, sum(rest, b), rest);
  }
  return {quotient, rest};
}

Bits Arithmetic::left(Bits a, const Bits& amount, Bit fill) {
  std::reverse(a.begin(), a.end());
  a = right(std::move(a), amount, fill);
  std::reverse(a.begin(), a.end());
  return a;
}

Bits Arithmetic::right(Bits a, const Bits& amount, Bit fill) {
  const std::size_t width = a.size();
  for (std::size_t bit = 0; bit < amount.size(); ++bit) {
    if (amount[bit] == no) continue;
    const bool is_beyond = bit >= 32 || (std::size_t{1} << bit) >= width;
    const std::size_t by = is_beyond ? width : std::size_t{1} << bit;
    Bits moved(width, fill);
    std::copy(a.begin() + static_cast<std::ptrdiff_t>(by), a.end(), moved.begin());
    a = choose(amount[bit], moved, a);
  }
  return a;
}

}  // namespace cosim::equiv
