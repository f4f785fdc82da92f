#include "model/toolpath/arc_geometry.h"
#include "model/core/wide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace cosim::toolpath {

namespace {

double length_mm(Position from, Position to) {
  return std::hypot(static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)) /
         pm_per_mm;
}

ArcGeometry none(const char* format, double value, double tolerance) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, value, tolerance);
  return {{}, 0, text.data()};
}

// The angle from `from` to `to` about `centre`, anticlockwise, in (0, 2 pi]. The products are exact
// so that the smallest angle keeps its sign.
double turn(Position centre, Position from, Position to) {
  const Int128 ax = from.x - centre.x;
  const Int128 ay = from.y - centre.y;
  const Int128 bx = to.x - centre.x;
  const Int128 by = to.y - centre.y;
  const auto cross = static_cast<double>(ax * by - ay * bx);
  const auto dot = static_cast<double>(ax * bx + ay * by);
  const double angle = std::atan2(cross, dot);
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

}  // namespace

double arc_tolerance(double radius_mm, double floor_mm) {
  return std::max(floor_mm, std::min(radius_mm / 1000, 0.5));
}

ArcGeometry arc_about(Position start, Position end, Position offset, bool clockwise,
                      double floor_mm) {
  const Position centre{start.x + offset.x, start.y + offset.y};
  const double radius = length_mm(centre, start);
  if (radius == 0) return {{}, 0, "the arc's radius is 0"};
  if (centre == end) return {{}, 0, "the arc's end is its centre"};
  const double off = std::abs(length_mm(centre, end) - radius);
  const double tolerance = arc_tolerance(radius, floor_mm);
  if (off > tolerance) {
    return none("the arc's end is %.6g mm off its circle; the tolerance is %.6g mm", off,
                tolerance);
  }
  const double sweep = clockwise ? turn(centre, end, start) : turn(centre, start, end);
  return {centre, sweep, {}};
}

ArcGeometry arc_of_radius(Position start, Position end, std::int64_t radius, bool clockwise,
                          double floor_mm) {
  if (start == end) return {{}, 0, "an arc by R needs an end other than its start"};
  if (radius == 0) return {{}, 0, "the arc's radius is 0"};
  const double half = length_mm(start, end) / 2;
  const double wanted = std::abs(static_cast<double>(radius)) / pm_per_mm;
  const double tolerance = arc_tolerance(wanted, floor_mm);
  if (2 * (half - wanted) > tolerance) {
    return none("the arc's chord is %.6g mm longer than 2 R; the tolerance is %.6g mm",
                2 * (half - wanted), tolerance);
  }
  // The centre lies on the chord's perpendicular: to its left for the short arc anticlockwise.
  const double r = std::max(wanted, half);
  const double height = std::sqrt((r - half) * (r + half));
  const double side = (radius > 0) == clockwise ? -1 : 1;
  const double scale = side * height / (2 * half);
  const auto dx = static_cast<double>(end.x - start.x);
  const auto dy = static_cast<double>(end.y - start.y);
  const Position centre{start.x + std::llround(dx / 2 - scale * dy),
                        start.y + std::llround(dy / 2 + scale * dx)};
  const double minor = 2 * std::asin(std::min(1.0, half / r));
  return {centre, radius > 0 ? minor : 2 * std::numbers::pi - minor, {}};
}

}  // namespace cosim::toolpath
