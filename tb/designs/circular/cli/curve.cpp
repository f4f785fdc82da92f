#include "tb/designs/circular/cli/curve.h"

#include <cmath>

namespace cosim::circular {

Curve curve_of(Point from, std::uint64_t radius2, Point to) {
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
