// Work that several algorithms can do, and what they make of it.
#pragma once

#include <cstdint>
#include <vector>

#include "model/plane/point.h"

namespace cosim::prior_art {

using plane::Point;

/// A line from (0, 0) to (major, minor), 0 <= minor <= major.
struct Line {
  std::int64_t major = 0;
  std::int64_t minor = 0;
};

/// An arc about (0, 0) in the first quadrant, anticlockwise: 0 <= to.x <= from.x, 0 <= from.y <=
/// to.y, both next to the circle.
struct Arc {
  Point from;
  std::uint64_t radius2 = 0;
  Point to;
};

/// The start, then the point after each elementary position; one that stays is a position without a
/// step.
using Points = std::vector<Point>;

}  // namespace cosim::prior_art
