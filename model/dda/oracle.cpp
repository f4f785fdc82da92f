#include "model/dda/oracle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace cosim::dda {

Track::Track(const Params& p, const Job& job)
    : width_(p.width),
      job_(job),
      sum_x_(job.start.sx),
      sum_y_(job.start.sy),
      at_{job.start.x, job.start.y},
      left_x_(job.start.left_x),
      left_y_(job.start.left_y) {
  const std::int64_t larger = std::max(std::abs(job.start.rate_x), std::abs(job.start.rate_y));
  if (job.start.normalise && larger != 0) {
    while ((larger << shifts_) >> (width_ - 1) == 0) ++shifts_;
  }
}

std::int64_t Track::rate_x(Point p) const {
  const State<Word>& s = job_.start;
  return (s.rate_x << shifts_) - s.b * (p.x - s.x) - s.two_c * (p.y - s.y);
}

std::int64_t Track::rate_y(Point p) const {
  const State<Word>& s = job_.start;
  return (s.rate_y << shifts_) + s.two_a * (p.x - s.x) + s.b * (p.y - s.y);
}

Point Track::rates() const { return {rate_x(at_), rate_y(at_)}; }

std::int64_t Track::whole(Sum sum) const { return static_cast<std::int64_t>(sum >> width_); }

std::optional<Point> Track::next() {
  const bool counted = job_.start.free == 0;
  if (counted && left_x_ == 0 && left_y_ == 0) return {};
  if (job_.clocks && clocks_ >= *job_.clocks) return {};
  if (clocks_++ < shifts_) return Point{};

  Point step;
  added_.x = rate_x(at_);
  const Sum to_x = sum_x_ + added_.x;
  if (!counted || left_x_ != 0) step.x = whole(to_x) - whole(sum_x_);
  const Point moved{at_.x + step.x, at_.y};
  added_.y = rate_y(job_.start.sequential ? moved : at_);
  const Sum to_y = sum_y_ + added_.y;
  if (!counted || left_y_ != 0) step.y = whole(to_y) - whole(sum_y_);

  sum_x_ = to_x;
  sum_y_ = to_y;
  at_ = {moved.x, at_.y + step.y};
  left_x_ -= std::abs(step.x);
  left_y_ -= std::abs(step.y);
  return step;
}

// With x and y from the start, and the start on the curve: the equation's left side is
// A x^2 + B xy + C y^2 + y'(0) x - x'(0) y, its gradient (y', -x') at (x, y). Of a circle it is A
// times the difference of the squares of the distance from its centre and of the radius.
double deviation(const Job& job, Point at) {
  using Real = long double;
  const State<Word>& s = job.start;
  const auto x = static_cast<Real>(at.x - s.x), y = static_cast<Real>(at.y - s.y);
  const auto two_a = static_cast<Real>(s.two_a), b = static_cast<Real>(s.b);
  const auto two_c = static_cast<Real>(s.two_c);
  const auto x0 = static_cast<Real>(s.rate_x), y0 = static_cast<Real>(s.rate_y);
  const Real value = two_a / 2 * x * x + b * x * y + two_c / 2 * y * y + y0 * x - x0 * y;
  if (value == 0) return 0;
  if (two_a == two_c && b == 0 && two_a != 0) {
    const Real centre_x = -y0 / two_a, centre_y = x0 / two_a;
    const Real radius = std::hypot(centre_x, centre_y);
    return static_cast<double>(std::fabs(value) * 2 / std::fabs(two_a) /
                               (std::hypot(x - centre_x, y - centre_y) + radius));
  }
  const Real along_x = y0 + two_a * x + b * y, along_y = -(x0 - b * x - two_c * y);
  const bool straight = s.two_a == 0 && s.b == 0 && s.two_c == 0;
  const Real slope =
      straight ? std::max(std::fabs(along_x), std::fabs(along_y)) : std::hypot(along_x, along_y);
  return static_cast<double>(std::fabs(value) / slope);
}

}  // namespace cosim::dda
