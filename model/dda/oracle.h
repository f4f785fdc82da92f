// The exact definition of the DDA's points, by sums and the curve's equation: an axis stands where
// the whole part of the sum of all its rates so far says, and each rate is that of the point.
#pragma once

#include <cstdint>
#include <optional>

#include "model/core/wide.h"
#include "model/dda/curve.h"

namespace cosim::dda {

/// The points of a job, a clock at a time. Its numbers do not wrap.
class Track {
 public:
  Track(int width, const Job& job);

  /// The steps of the next running clock, -1 to 1 on each axis; none where the job is over.
  std::optional<Point> next();

  Point at() const { return at_; }
  Point rates() const;                    ///< of the point
  Point added() const { return added_; }  ///< the rates of the last clock

 private:
  std::int64_t rate_x(Point p) const;
  std::int64_t rate_y(Point p) const;
  // The whole steps that the sum has come to.
  std::int64_t whole(Int128 sum) const;

  int width_;
  Job job_;
  int shifts_ = 0;
  std::int64_t clocks_ = 0;
  Int128 sum_x_, sum_y_;
  Point at_, added_;
  std::int64_t left_x_, left_y_;
};

}  // namespace cosim::dda
