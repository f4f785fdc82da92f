// The operations of symbols that few models need: products, shifts by values, bit by bit.
#include <algorithm>
#include <array>

#include "tb/proof/bits.h"

namespace cosim::proof {
namespace {

constexpr int word_bits = 64;

// Words whose two's complement code has `width` bits.
struct Range {
  Word least, most;
};
Range range_of(int width) {
  const Word most = cosim::low_bits(-1, width) / 2;
  return width == word_bits ? Range{cosim::shift_left(1, 63), cosim::low_bits(-1, 63)}
                            : Range{-most - 1, most};
}

// The operation on codes of `width` bits, which holds its result and both values.
Bits coded(const char* head, const Bits& a, const Bits& b, int width, const Range& bounds) {
  return {Expression(head, bit_vector(width), {a.code(width), b.code(width)}), width, bounds.least,
          bounds.most};
}

// Or, exclusive or: no more bits than the longer one.
Bits bitwise(const char* head, const Bits& a, const Bits& b) {
  const int width = std::max(a.width(), b.width());
  Range bounds = range_of(width);
  if (a.least() >= 0 && b.least() >= 0) bounds.least = 0;
  return coded(head, a, b, width, bounds);
}

}  // namespace

Bits operator*(const Bits& a, const Bits& b) {
  if (a.known() && b.known()) return Bits(cosim::multiply(*a.known(), *b.known()));
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
  if (!fits) return coded("bvmul", a, b, word_bits, range_of(word_bits));
  const auto [least, most] = std::minmax_element(ends.begin(), ends.end());
  const int width = std::max(Bits(*least).width(), Bits(*most).width());
  return coded("bvmul", a, b, width, {*least, *most});
}

Bits operator&(const Bits& a, const Bits& b) {
  if (a.known() && b.known()) return Bits(*a.known() & *b.known());
  if (a.known() == 0 || b.known() == -1) return a;
  if (b.known() == 0 || a.known() == -1) return b;
  int width = std::max(a.width(), b.width());
  Range bounds = range_of(width);
  if (a.least() >= 0 || b.least() >= 0) {
    const Word most = b.least() < 0   ? a.most()
                      : a.least() < 0 ? b.most()
                                      : std::min(a.most(), b.most());
    bounds = {0, most};
    width = Bits(most).width();
  }
  return coded("bvand", a, b, width, bounds);
}
Bits operator|(const Bits& a, const Bits& b) {
  if (a.known() && b.known()) return Bits(*a.known() | *b.known());
  if (a.known() == 0) return b;
  if (b.known() == 0) return a;
  return bitwise("bvor", a, b);
}
Bits operator^(const Bits& a, const Bits& b) {
  if (a.known() && b.known()) return Bits(*a.known() ^ *b.known());
  if (a.known() == 0) return b;
  if (b.known() == 0) return a;
  return bitwise("bvxor", a, b);
}

// A shift of SMT-LIB 2 takes its second code as a number without a sign too, and shifts every bit
// out where that is the width or more.
Bits shift_left(const Bits& v, const Bits& n) {
  if (v.known() && n.known()) return Bits(cosim::shift_left(*v.known(), *n.known()));
  if (n.known() && *n.known() >= 0 && *n.known() < word_bits) {
    return shift_left(v, static_cast<int>(*n.known()));
  }
  Range bounds = range_of(word_bits);
  int width = word_bits;
  if (n.least() >= 0 && v.width() + n.most() < word_bits) {
    const int far = static_cast<int>(n.most());
    bounds = {std::min(cosim::shift_left(v.least(), far), Word{0}),
              std::max(cosim::shift_left(v.most(), far), Word{0})};
    width = std::max(v.width() + far, n.width());
  }
  return coded("bvshl", v, n, width, bounds);
}
Bits shift_right(const Bits& v, const Bits& n) {
  if (v.known() && n.known()) return Bits(cosim::shift_right(*v.known(), *n.known()));
  if (n.known() && *n.known() >= 0 && *n.known() < word_bits) {
    return shift_right(v, static_cast<int>(*n.known()));
  }
  return coded("bvashr", v, n, std::max(v.width(), n.width()),
               {std::min(v.least(), Word{0}), std::max(v.most(), Word{-1})});
}

}  // namespace cosim::proof
