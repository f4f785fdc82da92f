// The source's flow chart, and its hardware, as they are told: no signs, accumulators that carry,
// the point in place of the rates. For the tests of a machine that does it otherwise.
#pragma once

#include <cstdint>
#include <vector>

#include "model/dda/curve.h"

namespace cosim::dda::flow_chart {

/// The points of a quarter from (radius, 0), one a clock, the start first. An axis that has no
/// steps left steps no more.
inline std::vector<Point> quarter(int width, std::int64_t radius, const Settings& settings) {
  const std::int64_t size = std::int64_t{1} << width;
  const std::int64_t first = settings.preload == Preload::half ? size / 2 : 0;
  std::int64_t sum_x = first, sum_y = first, kox = radius, koy = radius;
  Point at{radius, 0};
  std::vector<Point> points{at};
  while (kox > 0 || koy > 0) {
    const Point before = at;
    sum_x += at.y;
    if (sum_x >= size) {
      sum_x -= size;
      if (kox > 0) --kox, --at.x;
    }
    sum_y += settings.update == Update::sequential ? at.x : before.x;
    if (sum_y >= size) {
      sum_y -= size;
      if (koy > 0) --koy, ++at.y;
    }
    points.push_back(at);
  }
  return points;
}

}  // namespace cosim::dda::flow_chart
