// Bresenham's line: a step of the major axis on each position, of the minor one where it is nearer.
#pragma once

#include "model/prior_art/work.h"

namespace cosim::prior_art {

inline Points bresenham(const Line& line) {
  Points points{{0, 0}};
  std::int64_t error = 2 * line.minor - line.major;
  for (Point at{0, 0}; at.x < line.major;) {
    ++at.x;
    if (error > 0) {
      ++at.y;
      error -= 2 * line.major;
    }
    error += 2 * line.minor;
    points.push_back(at);
  }
  return points;
}

}  // namespace cosim::prior_art
