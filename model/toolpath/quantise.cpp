#include "model/toolpath/quantise.h"

#include <cmath>

namespace cosim::toolpath {

std::optional<Point> quantise(PointMm p, double steps_per_mm, std::int64_t reach) {
  const double x = p.x * steps_per_mm;
  const double y = p.y * steps_per_mm;
  const double limit = static_cast<double>(reach) + 0.5;
  if (!(std::abs(x) < limit && std::abs(y) < limit)) return std::nullopt;
  return Point{std::llround(x), std::llround(y)};
}

double distance(PointMm p, double steps_per_mm, Point q) {
  return std::hypot(p.x * steps_per_mm - static_cast<double>(q.x),
                    p.y * steps_per_mm - static_cast<double>(q.y));
}

}  // namespace cosim::toolpath
