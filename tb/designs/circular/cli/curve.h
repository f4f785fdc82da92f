// A part of a circle in a picture.
#pragma once

#include <cmath>

#include "model/circular/arc.h"
#include "tb/show/plot.h"

namespace cosim::circular {

/// The circle of R^2 = `radius2` about (0, 0), from the angle of `from` to that of `to`.
inline Curve curve_of(Point from, std::uint64_t radius2, Point to) {
  constexpr int parts = 64;
  const auto angle = [](Point p) {
    return std::atan2(static_cast<double>(p.y), static_cast<double>(p.x));
  };
  const double radius = std::sqrt(static_cast<double>(radius2));
  Curve curve;
  for (int i = 0; i <= parts; ++i) {
    const double at = angle(from) + (angle(to) - angle(from)) * i / parts;
    curve.emplace_back(radius * std::cos(at), radius * std::sin(at));
  }
  return curve;
}

}  // namespace cosim::circular
