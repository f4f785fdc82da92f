// What SU 1631518 leaves to the device outside: the control code UK for a line of BP by MP steps.
#pragma once

#include <cstdint>

namespace cosim::linear {

/// A control code of m bits. Bit m - 1 is a_1, the most significant; bit 0 is a_m.
using Code = std::uint64_t;

/// One piece of work for the machine. 0 <= major < 2^m; the code fixes the minor steps.
struct Line {
  std::int64_t major = 0;  ///< BP, steps on the leading axis
  Code code = 0;           ///< UK
};

/// B_i = floor((major + 2^(i-1)) / 2^i): the minor steps that bit a_i gives over the line.
/// 1 <= i <= m <= 32, 0 <= major < 2^m; 0 for an i or a major below these.
std::int64_t weight(int i, std::int64_t major);

/// The minor steps the code gives: the sum of a_i * B_i. Bits of the code above m are ignored.
std::int64_t minor_steps(int m, std::int64_t major, Code code);

/// The code that takes the heaviest weights first. Bits whose weight is 0 are left 0. Always exists
/// for 1 <= m <= 32, 0 <= minor <= major < 2^m; InputError otherwise.
Code greedy_code(int m, std::int64_t major, std::int64_t minor);

/// The code with the least max_deviation among all that give exactly `minor` steps; of equals the
/// numerically smallest. Bits whose weight is 0 are left 0. Exact and O(m): apart from those bits
/// there are never more than two codes to choose from. Errors as greedy_code.
Code best_code(int m, std::int64_t major, std::int64_t minor);

/// An exact non-negative deviation in steps: numerator / denominator.
struct Deviation {
  std::uint64_t whole = 0;        ///< whole steps
  std::uint64_t numerator = 0;    ///< the rest, over `denominator`
  std::uint64_t denominator = 1;  ///< BP, or 1 for an empty line
  double value() const;
  friend bool operator==(const Deviation&, const Deviation&) = default;
};
bool operator<(const Deviation& a, const Deviation& b);  // of one line: equal denominators

/// The largest |minor count - q * MP / BP| over the positions q = 0..BP, MP = minor_steps(code).
/// Exact and O(m): the difference is a sum over the bits of q, so the extremes are found digit by
/// digit. An empty line deviates by nothing.
Deviation max_deviation(int m, std::int64_t major, Code code);

}  // namespace cosim::linear
