#include "model/circular/oracle.h"
#include "model/core/wide.h"

#include <cmath>

namespace cosim::circular {

Point next_point(Point p, std::uint64_t radius2) {
  if (p.x > p.y) return {nearest_on(p.y + 1, radius2) < p.x ? p.x - 1 : p.x, p.y + 1};
  if (p.x < 1) return p;
  return {p.x - 1, nearest_on(p.x - 1, radius2) > p.y ? p.y + 1 : p.y};
}

namespace {

// The difference of two near roots would lose its digits: a - b = (a^2 - b^2) / (a + b), and the
// squares are exact.
double apart(Uint128 at, std::uint64_t radius2) {  // at most 2^127
  const Uint128 squares = at > radius2 ? at - radius2 : radius2 - at;
  if (squares == 0) return 0;
  const long double roots =
      std::sqrt(static_cast<long double>(at)) + std::sqrt(static_cast<long double>(radius2));
  return static_cast<double>(static_cast<long double>(squares) / roots);
}

}  // namespace

double radial_deviation(Point p, std::uint64_t radius2) {
  const auto square = [](std::int64_t v) {
    const Uint128 size = v < 0 ? -static_cast<Uint128>(v) : static_cast<Uint128>(v);
    return size * size;
  };
  return apart(square(p.x) + square(p.y), radius2);
}

double radial_deviation_by(std::int64_t excess, std::uint64_t radius2) {
  return apart(static_cast<Uint128>(radius2) + static_cast<Uint128>(excess), radius2);
}

double about_radial_deviation_by(std::int64_t excess, std::uint64_t radius2) {
  const auto at = static_cast<double>(radius2), by = static_cast<double>(excess);
  return std::fabs(by) / (std::sqrt(at + by) + std::sqrt(at));
}

}  // namespace cosim::circular
