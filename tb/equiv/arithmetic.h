// The operators of Verilog on words of an and-inverter graph. The lowest bit of a word is first.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "tb/nets/graph.h"

namespace cosim::equiv {

using nets::Bit;
using nets::Bits;
using nets::Graph;
using nets::no;
using nets::yes;

class Arithmetic {
 public:
  explicit Arithmetic(Graph& graph) : graph_(graph) {}

  /// Longer by copies of the highest bit if `is_signed`, else by 0; or cut.
  static Bits extended(Bits a, std::size_t width, bool is_signed);
  static Bits inverted(Bits a);

  Bit all(const Bits& a);
  Bit any(const Bits& a) { return !all(inverted(a)); }
  Bit parity(const Bits& a);
  /// Both have the same width, here and below.
  Bit equal(const Bits& a, const Bits& b);
  Bit less(const Bits& a, const Bits& b, bool is_signed);
  Bits choose(Bit condition, const Bits& then, const Bits& otherwise);

  /// a + b + carry, as wide as they are (a ripple-carry adder), by the gates that a model's sum has
  /// (nets/number.h).
  Bits sum(const Bits& a, const Bits& b, Bit carry = no);
  Bits difference(const Bits& a, const Bits& b) { return sum(a, inverted(b), yes); }
  Bits negated(const Bits& a) { return sum(inverted(a), Bits(a.size(), no), yes); }
  Bits product(const Bits& a, const Bits& b);
  /// Quotient and remainder, rounded to 0, or down where `floors` (a restoring divider). What comes
  /// of a divisor of 0 means nothing.
  std::pair<Bits, Bits> divided(const Bits& a, const Bits& b, bool is_signed, bool floors);

  /// By an unsigned amount of any width; `fill` comes in.
  Bits left(Bits a, const Bits& amount, Bit fill = no);
  Bits right(Bits a, const Bits& amount, Bit fill);

 private:
  std::pair<Bits, Bits> divided(const Bits& a, const Bits& b);

  Graph& graph_;
};

}  // namespace cosim::equiv
