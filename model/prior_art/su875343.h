// The circle of SU 875343, which SU 1665343 improves on: one rule, that of the octant from (R, 0),
// for any point. Y steps on every position; X - 1 with it where the point halfway between the two
// candidates is outside the circle. Past X = Y no diagonal turns the sign again: the path goes on
// along the tangent at 45 degrees.
//
// Its formula as SU 1665343 prints it, F' = F + 2 Y' - 1 after a straight step, is one row late;
// the reading here is the one whose points are the nearest up to 45 degrees.
#pragma once

#include "model/prior_art/work.h"

namespace cosim::prior_art {

/// Until X or, where it lies before 45 degrees, Y is that of the end. arc.from.x > arc.from.y,
/// radius2 < 2^48.
inline Points su875343(const Arc& arc) {
  Points points{arc.from};
  const auto square = [](std::int64_t v) { return v * v; };
  Point at = arc.from;
  std::int64_t value =
      square(at.x) - at.x + square(at.y + 1) - static_cast<std::int64_t>(arc.radius2);
  const bool before = arc.to.x > arc.to.y;
  while (before ? at.y < arc.to.y : at.x > arc.to.x) {
    ++at.y;
    if (value >= 0) {
      --at.x;
      value -= 2 * at.x;
    }
    value += 2 * at.y + 1;
    points.push_back(at);
  }
  return points;
}

}  // namespace cosim::prior_art
