#include "model/dda/equation.h"

#include <algorithm>
#include <cmath>

namespace cosim::dda {
namespace {

using Real = long double;

// The equation's left side, A x^2 + B xy + C y^2 + y'(0) x - x'(0) y with x and y from the start,
// and its gradient (y', -x').
class Equation {
 public:
  explicit Equation(const Start& s)
      : two_a(static_cast<Real>(s.two_a)),
        b(static_cast<Real>(s.b)),
        two_c(static_cast<Real>(s.two_c)),
        x0(static_cast<Real>(s.rate_x)),
        y0(static_cast<Real>(s.rate_y)) {}

  Real value(Real x, Real y) const {
    return two_a / 2 * x * x + b * x * y + two_c / 2 * y * y + y0 * x - x0 * y;
  }
  Real along_x(Real x, Real y) const { return y0 + two_a * x + b * y; }
  Real along_y(Real x, Real y) const { return -(x0 - b * x - two_c * y); }
  bool is_line() const { return two_a == 0 && b == 0 && two_c == 0; }
  bool is_circle() const { return two_a == two_c && b == 0 && two_a != 0; }
  /// Whether the value over the gradient is the distance but for an eighth of it: the gradient
  /// hardly changes on the way to the curve.
  bool is_straight_from(Real x, Real y) const {
    const Real bend = std::hypot((two_a + two_c) / 2, (two_a - two_c) / 2, b);
    const Real slope2 = along_x(x, y) * along_x(x, y) + along_y(x, y) * along_y(x, y);
    return 8 * bend * std::fabs(value(x, y)) <= slope2;
  }

  const Real two_a, b, two_c, x0, y0;
};

struct Way {
  Real x, y;
};

// From a point off the curve to the nearest point on it, w. There q + g w + w H w / 2 = 0 and
// w = -t (g + H w) for a multiplier t, which leaves 1 + t H without an eigenvalue below 0 where w
// is the shortest way (Moré, Generalizations of the trust region problem, 1993). With q > 0 what is
// left of q falls along t from 0 up: so t is found by halving. Where it does not fall to 0 before
// an eigenvalue does, as at a centre, the way goes on along that axis.
Way nearest(const Equation& curve, Real x, Real y) {
  const Real sign = curve.value(x, y) < 0 ? -1 : 1;
  const Real q = sign * curve.value(x, y);
  // The axes: `low` that of H's lower eigenvalue.
  const Real mean = sign * (curve.two_a + curve.two_c) / 2, b = sign * curve.b;
  const Real half = sign * (curve.two_a - curve.two_c) / 2, spread = std::hypot(half, b);
  const Real angle = std::atan2(b, half) / 2;
  const Way high{std::cos(angle), std::sin(angle)}, low{-high.y, high.x};
  const Real h_low = mean - spread, h_high = mean + spread;
  const Real along_x = sign * curve.along_x(x, y), along_y = sign * curve.along_y(x, y);
  const Real g_low = along_x * low.x + along_y * low.y;
  const Real g_high = along_x * high.x + along_y * high.y;

  // t by the share u of its range that is left, 1 to 0, so that 1 + t H is exact at either end.
  const auto way = [&](Real u) {
    const Real scale = h_low < 0 ? -h_low : h_high;
    const Real t = (1 - u) / scale;  // times 1 / u where nothing bounds it
    if (h_low >= 0) return Way{-t * g_low / (u + t * h_low), -t * g_high / (u + t * h_high)};
    const Real ratio = h_high / scale;
    return Way{-t * g_low / u, -t * g_high / (1 + ratio - u * ratio)};
  };
  const auto rest = [&](const Way& w) {
    return q + g_low * w.x + g_high * w.y + (h_low * w.x * w.x + h_high * w.y * w.y) / 2;
  };
  Real some = 1, none = 0;  // u with something left, and with nothing
  for (int i = 0; i < 160; ++i) {
    const Real u = (some + none) / 2;
    (rest(way(u)) > 0 ? some : none) = u;
  }
  Way w = way(some);
  if (none == 0 && h_low < 0) w.x += std::sqrt(std::max<Real>(0, 2 * rest(w) / -h_low));
  return {w.x * low.x + w.y * high.x, w.x * low.y + w.y * high.y};
}

// The value is A times the difference of two squares, of the distance from the centre and of the
// radius.
double off_circle(const Equation& curve, Real value, Real from_centre) {
  const Real radius = std::hypot(curve.x0, curve.y0) / std::fabs(curve.two_a);
  return static_cast<double>(std::fabs(value) * 2 / std::fabs(curve.two_a) /
                             (from_centre + radius));
}

}  // namespace

bool is_line_or_circle(const Job& job) {
  return job.start.b == 0 && job.start.two_a == job.start.two_c;
}

double deviation_by(const Job& job, std::int64_t twice) {
  if (twice == 0) return 0;
  const Equation curve(job.start);
  const Real value = static_cast<Real>(twice) / 2;
  if (curve.is_line()) {
    return static_cast<double>(std::fabs(value) /
                               std::max(std::fabs(curve.x0), std::fabs(curve.y0)));
  }
  const Real radius = std::hypot(curve.x0, curve.y0) / std::fabs(curve.two_a);
  return off_circle(curve, value, std::sqrt(radius * radius + 2 * value / curve.two_a));
}

double about_deviation_by(const Job& job, std::int64_t twice) {
  const auto by = static_cast<double>(twice), a = static_cast<double>(job.start.two_a);
  const auto x = static_cast<double>(job.start.rate_x), y = static_cast<double>(job.start.rate_y);
  if (a == 0) return std::fabs(by) / 2 / std::max(std::fabs(x), std::fabs(y));
  const double radius2 = (x * x + y * y) / (a * a);
  return std::fabs(by / a) / (std::sqrt(radius2 + by / a) + std::sqrt(radius2));
}

double deviation(const Job& job, Point at) {
  const Equation curve(job.start);
  const auto x = static_cast<Real>(at.x - job.start.x), y = static_cast<Real>(at.y - job.start.y);
  const Real value = curve.value(x, y);
  if (value == 0) return 0;
  if (curve.is_circle()) {
    const Real centre_x = -curve.y0 / curve.two_a, centre_y = curve.x0 / curve.two_a;
    return off_circle(curve, value, std::hypot(x - centre_x, y - centre_y));
  }
  if (!curve.is_straight_from(x, y)) {
    // The start is on the curve.
    const Way w = nearest(curve, x, y);
    return static_cast<double>(std::min(std::hypot(w.x, w.y), std::hypot(x, y)));
  }
  const Real along_x = curve.along_x(x, y), along_y = curve.along_y(x, y);
  const Real slope = curve.is_line() ? std::max(std::fabs(along_x), std::fabs(along_y))
                                     : std::hypot(along_x, along_y);
  return static_cast<double>(std::fabs(value) / slope);
}

// Newton's method, which has the digits of a picture after a few steps from a point near the curve.
std::pair<double, double> on_curve(const Job& job, Point at) {
  const Equation curve(job.start);
  auto x = static_cast<Real>(at.x - job.start.x), y = static_cast<Real>(at.y - job.start.y);
  if (curve.value(x, y) != 0 && !curve.is_straight_from(x, y)) {
    const Way w = nearest(curve, x, y);
    x += w.x;
    y += w.y;
  }
  for (int i = 0; i < 8; ++i) {
    const Real along_x = curve.along_x(x, y), along_y = curve.along_y(x, y);
    const Real slope2 = along_x * along_x + along_y * along_y;
    if (slope2 == 0) break;
    const Real by = curve.value(x, y) / slope2;
    x -= by * along_x;
    y -= by * along_y;
  }
  return {static_cast<double>(x + static_cast<Real>(job.start.x)),
          static_cast<double>(y + static_cast<Real>(job.start.y))};
}

}  // namespace cosim::dda
