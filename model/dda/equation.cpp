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
  explicit Equation(const State<Word>& s)
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

  const Real two_a, b, two_c, x0, y0;
};

}  // namespace

double deviation(const Job& job, Point at) {
  const Equation curve(job.start);
  const auto x = static_cast<Real>(at.x - job.start.x), y = static_cast<Real>(at.y - job.start.y);
  const Real value = curve.value(x, y);
  if (value == 0) return 0;
  if (curve.is_circle()) {
    // The value is A times the difference of two squares, of the distance from the centre and of
    // the radius.
    const Real centre_x = -curve.y0 / curve.two_a, centre_y = curve.x0 / curve.two_a;
    const Real radius = std::hypot(centre_x, centre_y);
    return static_cast<double>(std::fabs(value) * 2 / std::fabs(curve.two_a) /
                               (std::hypot(x - centre_x, y - centre_y) + radius));
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
