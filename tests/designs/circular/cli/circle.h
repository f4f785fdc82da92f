// The circle by itself: which lattice points are next to it, in exact integers.
#pragma once

#include <cmath>
#include <cstdint>

#include "model/core/wide.h"

namespace cosim::cli {

struct Lattice {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// Whether the point (x / 2, y / 2) is inside the circle.
inline bool inside(Int128 x, Int128 y, std::uint64_t radius2) {
  return x * x + y * y < 4 * static_cast<Int128>(radius2);
}

/// The next point towards (0, R), anticlockwise: in the sector x > y a row up, elsewhere a column
/// to the left; on the other axis a step where the point half a step away is on the wrong side.
inline Lattice next_on_circle(Lattice p, std::uint64_t radius2) {
  if (p.x > p.y) {
    const bool near = inside(2 * p.x - 1, 2 * (p.y + 1), radius2);
    return {near ? p.x : p.x - 1, p.y + 1};
  }
  const bool far = inside(2 * (p.x - 1), 2 * p.y + 1, radius2);
  return {p.x - 1, far ? p.y + 1 : p.y};
}

/// round(sqrt(radius2 - along^2)), the nearest point to the circle on a row or column; 0 outside.
inline std::int64_t across_from(std::int64_t along, std::uint64_t radius2) {
  std::int64_t high = std::int64_t{1} << 33, low = 0;
  while (low < high) {  // the least `low` with (low + 1/2)^2 + along^2 outside the circle
    const std::int64_t middle = (low + high) / 2;
    if (inside(2 * middle + 1, 2 * along, radius2)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

inline std::int64_t rounded_root(std::uint64_t radius2) { return across_from(0, radius2); }

/// |sqrt(x^2 + y^2) - R|, by the difference of the squares so that large circles lose no digits.
inline double radial_deviation(Lattice p, std::uint64_t radius2) {
  const Int128 difference = static_cast<Int128>(p.x) * p.x + static_cast<Int128>(p.y) * p.y -
                            static_cast<Int128>(radius2);
  if (difference == 0) return 0;
  const double sum = std::hypot(static_cast<double>(p.x), static_cast<double>(p.y)) +
                     std::sqrt(static_cast<double>(radius2));
  return std::abs(static_cast<double>(difference)) / sum;
}

}  // namespace cosim::cli
