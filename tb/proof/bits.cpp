// Symbolic execution with bounds: beside its formula each symbol has the least and the most that it
// can be (interval arithmetic). So a sum is as wide as its values need and no wider, and a
// comparison that the bounds decide is a constant. What may leave the machine word has the bounds
// of that word.
#include "tb/proof/bits.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace cosim::proof {
namespace {

constexpr int kWord = 64;
constexpr Word kLeast = std::numeric_limits<Word>::min();
constexpr Word kMost = std::numeric_limits<Word>::max();

// The bits of a number's shortest two's complement code.
int width_of(Word v) {
  return kWord + 1 - std::countl_zero(static_cast<std::uint64_t>(v < 0 ? ~v : v));
}

struct Bounds {
  Word least = kLeast;
  Word most = kMost;
  int width() const { return std::max(width_of(least), width_of(most)); }
};

// Words whose two's complement code has `width` bits.
Bounds range_of(int width) {
  const Word most = ones(width) / 2;
  return width == kWord ? Bounds{} : Bounds{-most - 1, most};
}

// The operation on codes of `width` bits, which holds its result and both values, and on codes that
// are as wide as the result.
BitVector made(const char* head, const BitVector& a, const BitVector& b, int width,
               const Bounds& bounds) {
  return {Expression(head, bit_vector(width), {a.code(width), b.code(width)}), width, bounds.least,
          bounds.most};
}
BitVector made(const char* head, const BitVector& a, const BitVector& b, const Bounds& bounds) {
  return made(head, a, b, bounds.width(), bounds);
}

// Or, exclusive or: no more bits than the longer one.
BitVector bitwise(const char* head, const BitVector& a, const BitVector& b) {
  const int width = std::max(a.width(), b.width());
  Bounds bounds = range_of(width);
  if (a.least() >= 0 && b.least() >= 0) bounds.least = 0;
  return made(head, a, b, width, bounds);
}

Truth compared(const char* head, const BitVector& a, const BitVector& b) {
  const int width = std::max(a.width(), b.width());
  return Truth(Expression(head, boolean, {a.code(width), b.code(width)}));
}

Expression literal(Word v, int width) {
  return {fmt::format("#b{:0{}b}", static_cast<std::uint64_t>(cosim::low_bits(v, width)), width),
          bit_vector(width)};
}

}  // namespace

Expression cut(const Expression& code, int low, int width) {
  if (low == 0 && code.sort() == bit_vector(width)) return code;
  return {fmt::format("(_ extract {} {})", low + width - 1, low), bit_vector(width), {code}};
}

Truth operator!(const Truth& a) {
  if (a.known()) return !*a.known();
  return Truth(negation(a.expression()));
}
Truth operator&(const Truth& a, const Truth& b) {
  if (a.known()) return *a.known() ? b : a;
  if (b.known()) return *b.known() ? a : b;
  return Truth(conjunction(a.expression(), b.expression()));
}
Truth operator|(const Truth& a, const Truth& b) {
  if (a.known()) return *a.known() ? a : b;
  if (b.known()) return *b.known() ? b : a;
  return Truth(disjunction(a.expression(), b.expression()));
}
Truth operator^(const Truth& a, const Truth& b) {
  if (a.known()) return *a.known() ? !b : b;
  if (b.known()) return *b.known() ? !a : a;
  return Truth(Expression("xor", boolean, {a.expression(), b.expression()}));
}

BitVector::BitVector(Word known)
    : least_(known),
      most_(known),
      width_(width_of(known)),
      expression_(literal(known, width_of(known))) {}

BitVector::BitVector(const Truth& t) : BitVector(select(t, BitVector(1), BitVector(0))) {}

BitVector::BitVector(const Expression& e, int width, Word least, Word most, int zeros)
    : least_(least),
      most_(most),
      width_(Bounds{least, most}.width()),
      zeros_(zeros),
      expression_(width > width_ ? cut(e, 0, width_) : e) {
  if (width < width_) {
    expression_ = {fmt::format("(_ sign_extend {})", width_ - width), bit_vector(width_), {e}};
  }
}

BitVector BitVector::unsigned_code(const Expression& code, int width) {
  if (width == kWord) return {code, kWord, kLeast, kMost};
  const Expression e("(_ zero_extend 1)", bit_vector(width + 1), {code});
  return {e, width + 1, 0, ones(width)};
}
BitVector BitVector::signed_code(const Expression& code, int width) {
  const auto [least, most] = range_of(width);
  return {code, width, least, most};
}

std::optional<Word> BitVector::known() const {
  return least_ == most_ ? std::optional(least_) : std::nullopt;
}

Expression BitVector::code(int width) const {
  if (known()) return literal(*known(), width);
  if (width <= width_) return cut(expression_, 0, width);
  return {fmt::format("(_ sign_extend {})", width - width_), bit_vector(width), {expression_}};
}

BitVector operator+(const BitVector& a, const BitVector& b) {
  if (a.known() == 0) return b;
  if (b.known() == 0) return a;
  if (a.known() && b.known()) return BitVector(cosim::add(*a.known(), *b.known()));
  if (a.code(a.width()).identity() == b.code(b.width()).identity()) return shift_left(a, 1);
  Bounds bounds;
  if (__builtin_add_overflow(a.least(), b.least(), &bounds.least) ||
      __builtin_add_overflow(a.most(), b.most(), &bounds.most)) {
    bounds = {};
  }
  // What fits into the zeros of the other is put there.
  if (a.zeros() > 0 && b.least() >= 0 && width_of(b.most()) <= a.zeros() + 1) {
    const int width = bounds.width(), high = width - a.zeros();
    return {Expression("concat", bit_vector(width),
                       {cut(a.code(width), a.zeros(), high), b.code(a.zeros())}),
            width, bounds.least, bounds.most};
  }
  return made("bvadd", a, b, bounds);
}
BitVector operator-(const BitVector& a, const BitVector& b) {
  if (b.known() == 0) return a;
  if (a.known() && b.known()) return BitVector(cosim::subtract(*a.known(), *b.known()));
  Bounds bounds;
  if (__builtin_sub_overflow(a.least(), b.most(), &bounds.least) ||
      __builtin_sub_overflow(a.most(), b.least(), &bounds.most)) {
    bounds = {};
  }
  return made("bvsub", a, b, bounds);
}
Truth operator<(const BitVector& a, const BitVector& b) {
  if (a.most() < b.least()) return true;
  if (a.least() >= b.most()) return false;
  return compared("bvslt", a, b);
}
Truth operator>(const BitVector& a, const BitVector& b) { return b < a; }
Truth operator==(const BitVector& a, const BitVector& b) {
  if (a.known() && b.known()) return *a.known() == *b.known();
  if (a.most() < b.least() || b.most() < a.least()) return false;
  return compared("=", a, b);
}
BitVector low_bits(const BitVector& v, int width) {
  if (v.known()) return BitVector(cosim::low_bits(*v.known(), width));
  if (width == kWord || (v.least() >= 0 && v.most() <= ones(width))) return v;
  return BitVector::unsigned_code(v.code(width), width);
}
Truth bit(const BitVector& v, int i) {
  if (v.known()) return cosim::bit(*v.known(), i);
  return Truth(equal(cut(v.code(std::max(v.width(), i + 1)), i, 1), literal(1, 1)));
}
BitVector shift_left(const BitVector& v, int n) {
  if (n == 0) return v;
  if (v.known()) return BitVector(cosim::shift_left(*v.known(), n));
  const Word factor = Word{1} << std::min(n, kWord - 2);
  Bounds bounds;
  if (n > kWord - 2 || __builtin_mul_overflow(v.least(), factor, &bounds.least) ||
      __builtin_mul_overflow(v.most(), factor, &bounds.most)) {
    bounds = {};
  }
  const int width = bounds.width();
  return {Expression("concat", bit_vector(width), {v.code(width - n), literal(0, n)}), width,
          bounds.least, bounds.most, n + v.zeros()};
}
BitVector shift_right(const BitVector& v, int n) {
  if (n == 0) return v;
  const Word least = cosim::shift_right(v.least(), n), most = cosim::shift_right(v.most(), n);
  if (least == most) return BitVector(least);
  const int width = std::max(v.width(), n + 1);
  return {cut(v.code(width), n, width - n), width - n, least, most};
}
BitVector select(const Truth& c, const BitVector& a, const BitVector& b) {
  if (c.known()) return *c.known() ? a : b;
  const Bounds bounds{std::min(a.least(), b.least()), std::max(a.most(), b.most())};
  if (bounds.least == bounds.most) return a;
  const int width = bounds.width();
  return {Expression("ite", bit_vector(width), {c.expression(), a.code(width), b.code(width)}),
          width, bounds.least, bounds.most};
}

// The operations that few models need: products, shifts by values, bit by bit.

BitVector operator*(const BitVector& a, const BitVector& b) {
  if (a.known() && b.known()) return BitVector(cosim::multiply(*a.known(), *b.known()));
  if (a.known() == 0 || b.known() == 1) return a;
  if (b.known() == 0 || a.known() == 1) return b;
  std::array<Word, 4> ends{};
  bool fits = true;
  std::size_t i = 0;
  for (const Word x : {a.least(), a.most()}) {
    for (const Word y : {b.least(), b.most()}) {
      fits = !__builtin_mul_overflow(x, y, &ends[i++]) && fits;
    }
  }
  if (!fits) return made("bvmul", a, b, kWord, range_of(kWord));
  const auto [least, most] = std::minmax_element(ends.begin(), ends.end());
  const int width = std::max(BitVector(*least).width(), BitVector(*most).width());
  return made("bvmul", a, b, width, {*least, *most});
}

BitVector operator&(const BitVector& a, const BitVector& b) {
  if (a.known() && b.known()) return BitVector(*a.known() & *b.known());
  if (a.known() == 0 || b.known() == -1) return a;
  if (b.known() == 0 || a.known() == -1) return b;
  int width = std::max(a.width(), b.width());
  Bounds bounds = range_of(width);
  if (a.least() >= 0 || b.least() >= 0) {
    const Word most = b.least() < 0   ? a.most()
                      : a.least() < 0 ? b.most()
                                      : std::min(a.most(), b.most());
    bounds = {0, most};
    width = BitVector(most).width();
  }
  return made("bvand", a, b, width, bounds);
}
BitVector operator|(const BitVector& a, const BitVector& b) {
  if (a.known() && b.known()) return BitVector(*a.known() | *b.known());
  if (a.known() == 0) return b;
  if (b.known() == 0) return a;
  return bitwise("bvor", a, b);
}
BitVector operator^(const BitVector& a, const BitVector& b) {
  if (a.known() && b.known()) return BitVector(*a.known() ^ *b.known());
  if (a.known() == 0) return b;
  if (b.known() == 0) return a;
  return bitwise("bvxor", a, b);
}

// A shift of SMT-LIB 2 takes its second code as a number without a sign too, and shifts every bit
// out where that is the width or more.
BitVector shift_left(const BitVector& v, const BitVector& n) {
  if (v.known() && n.known()) return BitVector(cosim::shift_left(*v.known(), *n.known()));
  if (n.known() && *n.known() >= 0 && *n.known() < kWord) {
    return shift_left(v, static_cast<int>(*n.known()));
  }
  Bounds bounds = range_of(kWord);
  int width = kWord;
  if (n.least() >= 0 && v.width() + n.most() < kWord) {
    const int far = static_cast<int>(n.most());
    bounds = {std::min(cosim::shift_left(v.least(), far), Word{0}),
              std::max(cosim::shift_left(v.most(), far), Word{0})};
    width = std::max(v.width() + far, n.width());
  }
  return made("bvshl", v, n, width, bounds);
}
BitVector shift_right(const BitVector& v, const BitVector& n) {
  if (v.known() && n.known()) return BitVector(cosim::shift_right(*v.known(), *n.known()));
  if (n.known() && *n.known() >= 0 && *n.known() < kWord) {
    return shift_right(v, static_cast<int>(*n.known()));
  }
  return made("bvashr", v, n, std::max(v.width(), n.width()),
              {std::min(v.least(), Word{0}), std::max(v.most(), Word{-1})});
}

}  // namespace cosim::proof
