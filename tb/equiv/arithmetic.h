// The operators of Verilog on words of an and-inverter graph. The lowest bit of a word is first.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "tb/proof/aig.h"

namespace cosim::equiv {

using Lits = std::vector<proof::Aig::Lit>;

class Arithmetic {
 public:
  using Lit = proof::Aig::Lit;

  explicit Arithmetic(proof::Aig& graph) : graph_(graph) {}

  /// Longer by copies of the highest bit if `is_signed`, else by 0; or cut.
  static Lits extended(Lits a, std::size_t width, bool is_signed);
  static Lits inverted(Lits a);

  Lit all(const Lits& a);
  Lit any(const Lits& a) { return proof::Aig::inverted(all(inverted(a))); }
  Lit parity(const Lits& a);
  /// Both have the same width, here and below.
  Lit equal(const Lits& a, const Lits& b);
  Lit less(const Lits& a, const Lits& b, bool is_signed);
  Lits choose(Lit condition, const Lits& then, const Lits& otherwise);

  /// a + b + carry, as wide as they are (a ripple-carry adder).
  Lits sum(const Lits& a, const Lits& b, Lit carry = 0);
  Lits difference(const Lits& a, const Lits& b) { return sum(a, inverted(b), 1); }
  Lits negated(const Lits& a) { return sum(inverted(a), Lits(a.size(), 0), 1); }
  Lits product(const Lits& a, const Lits& b);
  /// Quotient and remainder, rounded to 0, or down where `floors` (a restoring divider). What comes
  /// of a divisor of 0 means nothing.
  std::pair<Lits, Lits> divided(const Lits& a, const Lits& b, bool is_signed, bool floors);

  /// By an unsigned amount of any width; `fill` comes in.
  Lits left(Lits a, const Lits& amount, Lit fill = 0);
  Lits right(Lits a, const Lits& amount, Lit fill);

 private:
  std::pair<Lits, Lits> divided(const Lits& a, const Lits& b);

  proof::Aig& graph_;
};

}  // namespace cosim::equiv
