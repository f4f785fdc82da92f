#include "model/linear/control_code.h"

#include <algorithm>
#include <bit>
#include <string>

#include "model/core/input_error.h"
#include "model/core/wide.h"

namespace cosim::linear {
namespace {

// a_i, and 0 for an i that is no bit of the code.
int code_bit(int m, Code code, int i) {
  return 1 <= i && i <= m && m - i < 64 ? static_cast<int>(code >> (m - i) & 1) : 0;
}

void check(int m, std::int64_t major, std::int64_t minor) {
  using std::to_string;
  if (m < 1 || m > 32) throw InputError("a control code has 1 to 32 bits, not " + to_string(m));
  if (major < 0 || major >> m != 0) {
    throw InputError("a line of " + to_string(major) + " steps does not fit: a machine of " +
                     to_string(m) + " bits draws 0 to " + to_string((std::int64_t{1} << m) - 1));
  }
  if (minor < 0 || minor > major) {
    throw InputError("a line with " + to_string(major) + " steps on its major axis has 0 to " +
                     to_string(major) + " on the minor axis, not " + to_string(minor));
  }
}

// The only other code that can give as many steps as the greedy one; `greedy` itself where there is
// none.
//
// The weights after bit i sum to S = floor(BP / 2^i), and B_i is S or S + 1 (S where bit i - 1 of
// BP is 0). So with r steps still to give, a_i = 0 needs r <= S and a_i = 1 needs r >= B_i: a free
// choice means r = B_i = S. Taking a_i leaves nothing to give, refusing it leaves all that the
// later bits have; neither leaves another choice. The greedy code takes a_i, its last one. The
// other code turns that 10..0 into 01..1, down to the last bit with a weight: it is less by one
// unit of that bit.
Code other_code(int m, std::int64_t major, Code greedy) {
  if (greedy == 0) return greedy;
  const int i = m - std::countr_zero(greedy);
  if (weight(i, major) != major >> i) return greedy;
  // B_last = 1, and all 0 after it.
  const auto last = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(major)));
  return greedy - (Code{1} << (m - last));
}

}  // namespace

std::int64_t weight(int i, std::int64_t major) {
  if (i < 1 || i > 63 || major < 0) return 0;
  return (major >> i) + (major >> (i - 1) & 1);
}

std::int64_t minor_steps(int m, std::int64_t major, Code code) {
  std::int64_t sum = 0;
  for (int i = 1; i <= std::min(m, 63); ++i) sum += code_bit(m, code, i) * weight(i, major);
  return sum;
}

Code greedy_code(int m, std::int64_t major, std::int64_t minor) {
  check(m, major, minor);
  Code code = 0;
  std::int64_t rest = minor;
  for (int i = 1; rest > 0; ++i) {  // ends by i = m: the weights after i always hold the rest
    if (weight(i, major) > rest) continue;
    rest -= weight(i, major);
    code |= Code{1} << (m - i);
  }
  return code;
}

Code best_code(int m, std::int64_t major, std::int64_t minor) {
  const Code greedy = greedy_code(m, major, minor);
  const Code other = other_code(m, major, greedy);
  return max_deviation(m, major, greedy) < max_deviation(m, major, other) ? greedy : other;
}

double Deviation::value() const {
  return static_cast<double>(whole) +
         static_cast<double>(numerator) / static_cast<double>(denominator);
}

bool operator<(const Deviation& a, const Deviation& b) {
  return a.whole != b.whole ? a.whole < b.whole : a.numerator < b.numerator;
}

// Bit i gives floor((q + 2^(i-1)) / 2^i) = floor(q / 2^i) + (bit i - 1 of q) steps over q
// positions. Both terms are linear in the bits of q, and so is the difference: bit j of q, where it
// is 1, adds
//   gain_j = BP * (the sum of a_i * 2^(j-i) for i <= j, + a_(j+1)) - MP * 2^j
// to BP times the difference. The positions 0 .. BP mod 2^(j+1) with BP_j = 1 are those with q_j =
// 0 and all lower bits free, and those with q_j = 1 and the lower bits up to BP mod 2^j.
//
// All of it is below 4 * BP^2 where BP is not 0, so that 64 bits hold what is of 30.
template <class Int>
Deviation max_deviation_in(int m, std::int64_t major, Code code) {
  const Int minor = minor_steps(m, major, code);
  Int prefix = 0;                   // the sum of a_i * 2^(j-i) for i <= j
  Int high = 0, low = 0;            // the extremes over 0 .. BP mod 2^j
  Int free_high = 0, free_low = 0;  // and over 0 .. 2^j - 1
  for (int j = 0; major >> j != 0; ++j) {
    const int bit = code_bit(m, code, j + 1);
    const Int gain = major * (prefix + bit) - minor * (Int{1} << j);
    // Without a jump, which nothing could predict: all ones where the bit is 1, where the gain is
    // below 0.
    const Int is_one = -static_cast<Int>(major >> j & 1), is_below = -static_cast<Int>(gain < 0);
    high += is_one & (std::max(free_high, high + gain) - high);
    low += is_one & (std::min(free_low, low + gain) - low);
    free_high += gain & ~is_below;
    free_low += gain & is_below;
    prefix = 2 * prefix + bit;
  }
  const Int worst = std::max(high, -low);
  return {static_cast<std::uint64_t>(worst / major), static_cast<std::uint64_t>(worst % major),
          static_cast<std::uint64_t>(major)};
}

Deviation max_deviation(int m, std::int64_t major, Code code) {
  if (major <= 0) return {};
  return major >> 30 == 0 ? max_deviation_in<std::int64_t>(m, major, code)
                          : max_deviation_in<Int128>(m, major, code);
}

}  // namespace cosim::linear
