// A point of the grid, shared by designs that draw in a plane.
#pragma once

#include <cstdint>
#include <string>

namespace cosim::plane {

/// In steps.
struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// "(x, y)", for messages.
inline std::string text(Point p) {
  return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
}

}  // namespace cosim::plane
