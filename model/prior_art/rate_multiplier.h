// The linear prototype of SU 1631518: both axes from binary rate multipliers of m bits. An axis
// steps on position q = 2^(i-1) * odd where bit i of its length, from the highest, is 1; so it
// steps as often as its length says over 2^m positions, and every line takes all of them.
#pragma once

#include "model/prior_art/work.h"

namespace cosim::prior_art {

/// 2^m positions; line.major < 2^m, 1 <= m <= 24.
inline Points rate_multiplier(int m, const Line& line) {
  const std::int64_t positions = std::int64_t{1} << m;
  Points points{{0, 0}};
  for (std::int64_t q = 1; q <= positions; ++q) {
    const std::int64_t lowest_one = q & -q;
    const std::int64_t bit = positions / 2 / lowest_one;  // 0 at q = 2^m
    Point at = points.back();
    at.x += (line.major & bit) != 0;
    at.y += (line.minor & bit) != 0;
    points.push_back(at);
  }
  return points;
}

}  // namespace cosim::prior_art
