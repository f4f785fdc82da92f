#include "tb/nets/words.h"

#include <algorithm>

namespace cosim::nets {
namespace {

// The bits that give both words as numbers with a sign: all above are copies of the last one.
std::size_t signed_width(const Bits& a, const Bits& b) {
  std::size_t n = a.size();
  while (n > 1 && a[n - 1] == a[n - 2] && b[n - 1] == b[n - 2]) --n;
  return n;
}
// Those that give a as a number without a sign: all above are 0.
std::size_t unsigned_width(const Bits& a) {
  std::size_t n = a.size();
  while (n > 0 && a[n - 1] == no) --n;
  return n;
}

// The carry out of the lower n bits of a + b.
Bit carried(Graph& graph, const Bits& a, const Bits& b, std::size_t n, Bit carry) {
  for (std::size_t i = 0; i < n; ++i) carry = graph.mux(graph.xor_of(a[i], b[i]), carry, a[i]);
  return carry;
}

// -a where `minus` holds, else a.
Bits negated_where(Graph& graph, Bit minus, Bits a) {
  for (Bit& bit : a) bit = graph.xor_of(bit, minus);
  return sum(graph, Bits(a.size(), no), a, minus);
}
Bits magnitude(Graph& graph, const Bits& a) {
  const Bits needed = resized(a, signed_width(a, a), no);
  return resized(negated_where(graph, a.back(), needed), a.size(), no);
}

}  // namespace

Bits resized(Bits a, std::size_t width, Bit above) {
  a.resize(width, above);
  return a;
}

Bits inverted(Bits a) {
  for (Bit& bit : a) bit = !bit;
  return a;
}

Bits chosen(Graph& graph, Bit condition, const Bits& a, const Bits& b) {
  Bits bits;
  for (std::size_t i = 0; i < a.size(); ++i) bits.push_back(graph.mux(condition, a[i], b[i]));
  return bits;
}

Bits sum(Graph& graph, const Bits& a, const Bits& b, Bit carry) {
  const std::size_t width = std::min(a.size(), signed_width(a, b) + 1);
  Bits bits;
  for (std::size_t i = 0; i < width; ++i) {
    const Bit odd = graph.xor_of(a[i], b[i]);
    bits.push_back(graph.xor_of(odd, carry));
    if (i + 1 < width) carry = graph.mux(odd, carry, a[i]);
  }
  return resized(bits, a.size(), bits.back());
}

// One row for each bit of b. The last one, its sign, counts less than nothing.
Bits product(Graph& graph, const Bits& a, const Bits& b) {
  const auto is_constant = [](const Bits& word) {
    return std::ranges::all_of(word, [](Bit bit) { return bit.is_constant(); });
  };
  if (is_constant(a) && !is_constant(b)) return product(graph, b, a);
  const std::size_t width = a.size(), rows = signed_width(b, b);
  Bits all(width, no);
  for (std::size_t i = 0; i < rows; ++i) {
    Bits row(width, no);
    for (std::size_t k = i; k < width; ++k) row[k] = graph.and_of(a[k - i], b[i]);
    all = i + 1 < rows ? sum(graph, all, row) : difference(graph, all, row);
  }
  return all;
}

// Long division. A remainder is less than b, and has no more bits, unless b is 0.
Division divided(Graph& graph, const Bits& a, const Bits& b) {
  const std::size_t width = a.size(), most = unsigned_width(b);
  Bits above(width + 1, no);  // whether b has a bit there or above
  for (std::size_t i = width; i-- > 0;) above[i] = graph.or_of(above[i + 1], b[i]);
  Bits quotient(width), rest;
  for (std::size_t i = width; i-- > 0;) {
    rest.insert(rest.begin(), a[i]);
    rest.resize(unsigned_width(rest));
    const std::size_t n = rest.size(), kept = std::min(n, most);
    const Bits by = inverted(resized(b, n, no));
    quotient[i] = graph.and_of(!above[n], carried(graph, rest, by, n, yes));
    rest.resize(kept);
    if (kept == 0) continue;
    rest = chosen(graph, quotient[i], sum(graph, rest, resized(by, kept, no), yes), rest);
  }
  rest.resize(width, no);
  if (unsigned_width(a) > most) rest = chosen(graph, above[0], rest, a);
  return {quotient, rest};
}

Division divided_with_sign(Graph& graph, const Bits& a, const Bits& b) {
  const Division plain = divided(graph, magnitude(graph, a), magnitude(graph, b));
  return {negated_where(graph, graph.xor_of(a.back(), b.back()), plain.quotient),
          negated_where(graph, a.back(), plain.remainder)};
}

Bits shifted_down(Graph& graph, Bits a, const Bits& n, Bit fill) {
  const std::size_t width = a.size();
  std::size_t by = 1;
  Bit leaves_none = no;
  for (const Bit bit : n) {
    if (by >= width) {
      leaves_none = graph.or_of(leaves_none, bit);
      continue;
    }
    for (std::size_t i = 0; i < width; ++i) {
      a[i] = graph.mux(bit, i + by < width ? a[i + by] : fill, a[i]);
    }
    by *= 2;
  }
  return chosen(graph, leaves_none, Bits(width, fill), a);
}
Bits shifted_up(Graph& graph, Bits a, const Bits& n) {
  std::ranges::reverse(a);
  a = shifted_down(graph, std::move(a), n, no);
  std::ranges::reverse(a);
  return a;
}

Bit equal(Graph& graph, const Bits& a, const Bits& b) {
  const std::size_t width = signed_width(a, b);
  return !graph.differ(std::span(a).first(width), std::span(b).first(width));
}
// By the gates that a model's comparison has (number.h).
Bit less(Graph& graph, const Bits& a, const Bits& b, bool is_signed) {
  Bit result = no;
  const std::size_t width = signed_width(a, b);
  for (std::size_t i = 0; i < width; ++i) {
    const bool is_sign = is_signed && i + 1 == width;
    result = graph.mux(graph.xor_of(a[i], b[i]), is_sign ? a[i] : b[i], result);
  }
  return result;
}

}  // namespace cosim::nets
