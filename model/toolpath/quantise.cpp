#include "model/toolpath/quantise.h"

#include <cmath>
#include <limits>

#include "model/toolpath/arc_geometry.h"

namespace cosim::toolpath {

namespace {

// Of a coordinate, which is a whole number of picometres, and a scale as a person wrote it. The
// scale's double is half a unit of its last place off at the most, and a half is a half for all
// that: 4.475 mm at 100 steps are 447.5.
long double steps(double mm, double steps_per_mm) {
  constexpr long double last_place = std::numeric_limits<double>::epsilon();
  const long double exact =
      std::round(mm * static_cast<long double>(pm_per_mm)) * steps_per_mm / pm_per_mm;
  return exact * (1 + last_place);
}

}  // namespace

std::optional<Point> quantise(PointMm p, double steps_per_mm, std::int64_t reach) {
  const long double x = steps(p.x, steps_per_mm);
  const long double y = steps(p.y, steps_per_mm);
  const long double limit = static_cast<long double>(reach) + 0.5L;
  if (!(std::abs(x) < limit && std::abs(y) < limit)) return std::nullopt;
  return Point{std::llround(x), std::llround(y)};
}

double distance(PointMm p, double steps_per_mm, Point q) {
  return std::hypot(p.x * steps_per_mm - static_cast<double>(q.x),
                    p.y * steps_per_mm - static_cast<double>(q.y));
}

}  // namespace cosim::toolpath
