// The machine word of the golden models as bits of a graph: a model run on Number in place of Word
// makes the gates of what it does.
#pragma once

#include <optional>
#include <vector>

#include "model/core/value.h"
#include "tb/nets/graph.h"

namespace cosim::nets {

/// A condition; a known one belongs to no graph.
class Truth : public SymbolicCondition {
 public:
  Truth(bool known) : bit_(known ? yes : no) {}  // NOLINT: a truth value is one
  Truth(Graph& graph, Bit bit) : graph_(&graph), bit_(bit) {}

  Bit bit() const { return bit_; }
  std::optional<bool> known() const {
    return bit_.is_constant() ? std::optional(bit_ == yes) : std::nullopt;
  }
  Graph* graph() const { return graph_; }

 private:
  Graph* graph_ = nullptr;
  Bit bit_;
};

inline Bit fact_of(const Truth& t) { return t.bit(); }

Truth operator!(const Truth& a);
Truth operator&(const Truth& a, const Truth& b);
Truth operator|(const Truth& a, const Truth& b);
Truth operator^(const Truth& a, const Truth& b);

/// A Word: a two's complement code of 64 bits or fewer, the last one standing for all above it. It
/// wraps as a Word does. A known one belongs to no graph.
class Number : public Symbolic {
 public:
  Number() : Number(0) {}
  Number(Word known);      // NOLINT: a number is one
  Number(const Truth& t);  // NOLINT: 1 or 0
  /// A code, lowest bit first, 1 to 64 of them: as the number it is without a sign, which of 64
  /// bits is a bit pattern, or in two's complement.
  static Number unsigned_code(Graph& graph, std::vector<Bit> code);
  static Number signed_code(Graph& graph, std::vector<Bit> code);

  /// Bit i of the two's complement code, i >= 0.
  Bit at(int i) const;
  /// The lower `width` bits of it, lowest first.
  std::vector<Bit> code(int width) const;
  /// How many bits it has, the others being the same as the last.
  int width() const { return static_cast<int>(bits_.size()); }
  std::optional<Word> known() const;
  Graph* graph() const { return graph_; }

  /// The same number as a code in two's complement and 1 more where `carry` holds. What was negated
  /// has one without a carry through all bits, so that a sum that takes it has no more than its
  /// own.
  struct Open {
    std::vector<Bit> bits;
    Bit carry = no;
    Bit at(int i) const;  ///< as of a Number
  };
  Open open() const { return open_.value_or(Open{bits_, no}); }
  bool has_open() const { return open_.has_value(); }
  Number with_open(Open open) &&;

 private:
  Number(Graph* graph, std::vector<Bit> bits);

  Graph* graph_ = nullptr;
  std::vector<Bit> bits_;
  std::optional<Open> open_;
};

Number operator+(const Number& a, const Number& b);
Number operator-(const Number& a, const Number& b);
Number operator*(const Number& a, const Number& b);
Number operator&(const Number& a, const Number& b);
Number operator|(const Number& a, const Number& b);
Number operator^(const Number& a, const Number& b);
Truth operator<(const Number& a, const Number& b);
Truth operator>(const Number& a, const Number& b);
Truth operator==(const Number& a, const Number& b);
Number low_bits(const Number& v, int width);
Truth bit(const Number& v, int i);
Number shift_left(const Number& v, int n);
Number shift_right(const Number& v, int n);
Number shift_left(const Number& v, const Number& n);
Number shift_right(const Number& v, const Number& n);
Number select(const Truth& c, const Number& a, const Number& b);

// The operators wrap already.
inline Number add(const Number& a, const Number& b) { return a + b; }
inline Number subtract(const Number& a, const Number& b) { return a - b; }
inline Number multiply(const Number& a, const Number& b) { return a * b; }

}  // namespace cosim::nets
