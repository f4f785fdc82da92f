#include "model/dda/oracle.h"

#include <algorithm>
#include <cstdlib>

namespace cosim::dda {

Track::Track(int width, const Job& job)
    : width_(width),
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
  const Start& s = job_.start;
  return (s.rate_x << shifts_) - s.b * (p.x - s.x) - s.two_c * (p.y - s.y);
}

std::int64_t Track::rate_y(Point p) const {
  const Start& s = job_.start;
  return (s.rate_y << shifts_) + s.two_a * (p.x - s.x) + s.b * (p.y - s.y);
}

Point Track::rates() const { return {rate_x(at_), rate_y(at_)}; }

std::int64_t Track::whole(Int128 sum) const { return static_cast<std::int64_t>(sum >> width_); }

std::optional<Point> Track::next() {
  const bool counted = !job_.start.free;
  if (counted && left_x_ == 0 && left_y_ == 0) return {};
  if (job_.clocks && clocks_ >= *job_.clocks) return {};
  if (clocks_++ < shifts_) return Point{};

  Point step;
  added_.x = rate_x(at_);
  const Int128 to_x = sum_x_ + added_.x;
  if (!counted || left_x_ != 0) step.x = whole(to_x) - whole(sum_x_);
  const Point moved{at_.x + step.x, at_.y};
  added_.y = rate_y(job_.start.sequential ? moved : at_);
  const Int128 to_y = sum_y_ + added_.y;
  if (!counted || left_y_ != 0) step.y = whole(to_y) - whole(sum_y_);

  sum_x_ = to_x;
  sum_y_ = to_y;
  at_ = {moved.x, at_.y + step.y};
  left_x_ -= std::abs(step.x);
  left_y_ -= std::abs(step.y);
  return step;
}

}  // namespace cosim::dda
