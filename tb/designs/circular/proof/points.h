// What the circular machine holds at a point of its arc, by the source's formulas; X and Y are the
// point, and D is R^2 - X^2 - Y^2, with which everything is linear.
#pragma once

#include <array>

namespace cosim::circular {

/// The numbers of T4, T16, F in quarters, CT7 and CT8, as the model has them.
template <class V>
using Numbers = std::array<V, 5>;

template <class V>
struct ArcPoint {
  V x, y, d;
};

// F is the midpoint of the next two points, between their values of d: in quarters, for it always
// has a fraction of 3/4. The midpoint of (x, y + 1) and (x - 1, y + 1) has d + x - 2y - 1 - 1/4,
// that of (x - 1, y) and (x - 1, y + 1) has d + 2x - 1 - y - 1/4.
template <class V>
V f_in_sector1(const ArcPoint<V>& p) {
  return shift_left(p.d + p.x - p.y - p.y - V(1), 2) - V(1);
}
template <class V>
V f_in_sector2(const ArcPoint<V>& p) {
  return shift_left(p.d + p.x + p.x - V(1) - p.y, 2) - V(1);
}

/// On its way, in the one sector and in the other.
template <class V>
Numbers<V> in_sector1(const ArcPoint<V>& p) {
  return {V(1), V(0), f_in_sector1(p), p.y, p.x - p.y - V(1)};
}
template <class V>
Numbers<V> in_sector2(const ArcPoint<V>& p) {
  return {V(1), V(1), f_in_sector2(p), p.x - V(1), p.x - p.y};
}

}  // namespace cosim::circular
