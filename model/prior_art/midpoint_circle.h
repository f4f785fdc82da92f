// The midpoint circle: an octant from (R, 0) by the sign of the equation halfway between the next
// two candidates, kept up to date by additions; the other octant is its mirror image.
#pragma once

#include "model/circular/arc.h"
#include "model/prior_art/work.h"

namespace cosim::prior_art {

/// The octant: a point a row, from (R, 0) while x >= y.
inline Points midpoint_octant(std::uint64_t radius2) {
  Points points;
  Point at{circular::nearest_root(radius2), 0};
  // (x - 1/2)^2 + (y + 1)^2 - R^2, less its quarter.
  std::int64_t decision = at.x * at.x - at.x + 1 - static_cast<std::int64_t>(radius2);
  while (at.x >= at.y) {
    points.push_back(at);
    ++at.y;
    if (decision >= 0) {
      --at.x;
      decision -= 2 * at.x;
    }
    decision += 2 * at.y + 1;
  }
  return points;
}

/// radius2 < 2^48.
inline Points midpoint_circle(const Arc& arc) {
  const Points octant = midpoint_octant(arc.radius2);
  Points points{arc.from};
  const auto add = [&](Point p) {
    const bool before = p.y < arc.from.y || p.x > arc.from.x;
    const bool after = p.y > arc.to.y || p.x < arc.to.x;
    if (!before && !after && !(p == points.back())) points.push_back(p);
  };
  for (const Point& p : octant) add(p);
  for (std::size_t i = octant.size(); i-- > 0;) add({octant[i].y, octant[i].x});
  return points;
}

}  // namespace cosim::prior_art
