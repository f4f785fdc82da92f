// The circle by an evaluation function with one axis a step: outside the circle or on it X - 1,
// inside it Y + 1. There are no diagonals.
#pragma once

#include "model/prior_art/work.h"

namespace cosim::prior_art {

/// radius2 < 2^48. An axis that has come to its end steps no more.
inline Points single_axis_circle(const Arc& arc) {
  Points points{arc.from};
  const auto square = [](std::int64_t v) { return v * v; };
  std::int64_t value =
      square(arc.from.x) + square(arc.from.y) - static_cast<std::int64_t>(arc.radius2);
  for (Point at = arc.from; at.x > arc.to.x || at.y < arc.to.y;) {
    if (at.y >= arc.to.y || (value >= 0 && at.x > arc.to.x)) {
      value -= 2 * at.x - 1;
      --at.x;
    } else {
      value += 2 * at.y + 1;
      ++at.y;
    }
    points.push_back(at);
  }
  return points;
}

}  // namespace cosim::prior_art
