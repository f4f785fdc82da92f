// Arithmetic on words of gates, as BTOR2 defines it. A word is its bits, the lowest first, 1 or
// more. The two words of an operation have one width, and so has the result, which wraps. A word
// that was widened, with or without a sign, comes to the gates of the bits that it had before.
#pragma once

#include "tb/nets/graph.h"

namespace cosim::nets {

/// The lower `width` bits of the word, or all behind as many of `above` as are missing.
Bits resized(Bits a, std::size_t width, Bit above);
Bits inverted(Bits a);
/// a where `condition` holds, else b.
Bits chosen(Graph& graph, Bit condition, const Bits& a, const Bits& b);

/// a + b, and 1 more where `carry` holds.
Bits sum(Graph& graph, const Bits& a, const Bits& b, Bit carry = no);
inline Bits difference(Graph& graph, const Bits& a, const Bits& b) {
  return sum(graph, a, inverted(b), yes);
}
Bits product(Graph& graph, const Bits& a, const Bits& b);

struct Division {
  Bits quotient, remainder;
};
/// Of numbers without a sign. Division by 0 gives a quotient of ones and the remainder a.
Division divided(Graph& graph, const Bits& a, const Bits& b);
/// Of numbers with a sign: the division of their magnitudes, by 0 as well, whose quotient is
/// negated where the signs differ, and whose remainder is negated where a is negative.
Division divided_with_sign(Graph& graph, const Bits& a, const Bits& b);

/// a moved down or up by the number n, which has no sign; a.size() or more leaves `fill`, or 0.
Bits shifted_down(Graph& graph, Bits a, const Bits& n, Bit fill);
Bits shifted_up(Graph& graph, Bits a, const Bits& n);

Bit equal(Graph& graph, const Bits& a, const Bits& b);
/// a < b, as numbers without a sign or with one.
Bit less(Graph& graph, const Bits& a, const Bits& b, bool is_signed = false);

}  // namespace cosim::nets
