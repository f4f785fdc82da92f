// The check of an arc, see model/core/job.h: which of the two points in reach is nearest to the
// circle, from the steps alone. It knows x^2 + y^2 - R^2 of the point that it stands on.
#pragma once

#include "model/circular/drive.h"

namespace cosim::circular {

// clang-format off
/// What is due of the arc, and where it stands. A step changes the excess by less than
/// 2^(width + 2), and before it was less than 2^width: so it is right up to the first step that is
/// not.
#define CIRCULAR_CHECKER(FIELD)                                                                    \
  FIELD(whole,   1,           flag,            "", "they lead to its end")                         \
  FIELD(end_y,   p.width + 1, number,          "", "where x is 0")                                 \
  FIELD(x1,      p.width + 2, twos_complement, "", "the point: x - 1")                             \
  FIELD(y,       p.width + 1, number,          "", "")                                             \
  FIELD(excess,  p.width + 4, twos_complement, "", "x^2 + y^2 - R^2")                              \
  FIELD(steps,   p.width + 2, number,          "", "its steps")                                    \
  FIELD(least,   p.width + 4, twos_complement, "", "excess of this arc")                           \
  FIELD(most,    p.width + 4, twos_complement, "", "")
// clang-format on

COSIM_RECORD(Checker, CIRCULAR_CHECKER, Params);

/// Of an arc that the machine holds.
Checker<Word> checker_of(const Params& p, const Arc& arc);

/// Wrong is a step, the number of them or the last point.
template <class V>
constexpr Verdict<Checker, V> checked(const Params&, const Task<V>&, const Driver<V>& driver,
                                      const Checker<V>& w, const Outputs<V>& seen,
                                      Condition<V> over) {
  const Condition<V> up = is_set(seen.step_y), left = is_set(seen.step_x), any = up | left;
  const auto twice_and_one = [](const V& v) { return shift_left(v, 1) + V(1); };

  Checker<V> n = w;
  n.x1 = w.x1 - seen.step_x;
  n.y = w.y + seen.step_y;
  n.excess =
      w.excess + select(up, twice_and_one(w.y), V(0)) - select(left, twice_and_one(w.x1), V(0));
  n.least = select(n.excess < w.least, n.excess, w.least);
  n.most = select(n.excess > w.most, n.excess, w.most);

  // In sector 1 each step goes up, and left where the circle is nearer to x - 1 on that row. Of the
  // point that it comes to, x^2 + y^2 - R^2 < x where it did not go left, else it is -x or more. In
  // sector 2 that is so of y, and each step goes left, and up or not.
  const Condition<V> sector1 = !(w.x1 < w.y);
  const Condition<V> must = (sector1 & up) | (!sector1 & left);
  const Condition<V> outer = (sector1 & !left) | (!sector1 & up);
  // excess - x or excess + x, and likewise of y, as one sum: -x is x - 1 turned over, -y - 1 is y.
  const V by = select(sector1, n.x1, n.y), carry = flag<V>(sector1 ^ outer);
  const Condition<V> below =
      (shift_left(n.excess, 1) | carry) + (shift_left(by ^ select(outer, V(-1), V(0)), 1) | carry) <
      V(0);
  const Condition<V> past = !sector1 & (w.x1 < V(0));
  const Condition<V> at_end = (n.x1 == V(-1)) & (n.y == w.end_y);
  const Condition<V> ended = (driver.steps == w.steps) & (at_end | !is_set(w.whole)) & !any;
  const Condition<V> wrong = (any & (past | !must | (outer ^ below))) | (over & !ended);
  return {n, wrong};
}

}  // namespace cosim::circular
