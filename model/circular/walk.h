// The oracle of the circular machine as a step function over a value type, for as many arcs as
// there are lanes: which of the two points in reach is nearest to the circle, from the steps alone.
// It knows x^2 + y^2 - R^2 of the point that it stands on.
#pragma once

#include "model/circular/arc.h"
#include "model/circular/machine.h"

namespace cosim::circular {

// clang-format off
/// What is due of an arc.
#define CIRCULAR_DUE(FIELD)                                                                        \
  FIELD(x,       p.width + 1, number,          "", "its start")                                    \
  FIELD(y,       p.width + 1, number,          "", "")                                             \
  FIELD(excess,  p.width + 4, twos_complement, "", "x^2 + y^2 - R^2 there")                        \
  FIELD(steps,   p.width + 2, number,          "", "its steps")                                    \
  FIELD(whole,   1,           flag,            "", "they lead to its end")                         \
  FIELD(end_y,   p.width + 1, number,          "", "where x is 0")

/// Where it stands. A step changes the excess by less than 2^(width + 2), and before it was less
/// than 2^width: so it is right up to the first step that is not.
#define CIRCULAR_WALKED(FIELD)                                                                     \
  FIELD(x,       p.width + 1, number,          "", "the point")                                    \
  FIELD(y,       p.width + 1, number,          "", "")                                             \
  FIELD(excess,  p.width + 4, twos_complement, "", "x^2 + y^2 - R^2")                              \
  FIELD(steps,   p.width + 2, number,          "", "so far")                                       \
  FIELD(least,   p.width + 4, twos_complement, "", "excess of this arc")                           \
  FIELD(most,    p.width + 4, twos_complement, "", "")
// clang-format on

COSIM_RECORD(Due, CIRCULAR_DUE, Params);
COSIM_RECORD(Walked, CIRCULAR_WALKED, Params);

/// Of an arc that the machine holds.
Due<Word> due_of(const Params& p, const Arc& arc);

template <class V>
struct Verdict {
  Walked<V> walked;
  Condition<V> wrong;  ///< a step, the number of them or the last point is not what is due
};

/// After a clock with these outputs, the first or the last one of its arc or one between them.
template <class V>
constexpr Verdict<V> walked(const Params&, const Due<V>& due, const Walked<V>& w,
                            const Outputs<V>& seen, Condition<V> first, Condition<V> over) {
  const Condition<V> up = is_set(seen.step_y), left = is_set(seen.step_x), steps = up | left;
  const V one = V(1);
  const V above = w.excess + w.y + w.y + one;   // of (x, y + 1)
  const V beside = w.excess - w.x - w.x + one;  // of (x - 1, y)
  // Left where (x - 1/2)^2 is more than what is left for it on the row above; up where (y + 1/2)^2
  // is less than what is left for it in the column beside.
  const Condition<V> sector1 = w.x > w.y;
  const Condition<V> due_left = !sector1 | !(above < w.x);
  const Condition<V> due_up = sector1 | (beside + w.y < V(0));
  const Condition<V> past = !sector1 & (w.x == V(0));

  Walked<V> n;
  n.x = w.x - seen.step_x;
  n.y = w.y + seen.step_y;
  n.excess =
      select(up, select(left, above - w.x - w.x + one, above), select(left, beside, w.excess));
  n.steps = w.steps + flag<V>(steps);
  n.least = select(n.excess < w.least, n.excess, w.least);
  n.most = select(n.excess > w.most, n.excess, w.most);
  const Condition<V> at_end = (n.x == V(0)) & (n.y == due.end_y);
  const Condition<V> ended = (n.steps == due.steps) & (at_end | !is_set(due.whole));
  const Condition<V> wrong = (steps & (past | (up ^ due_up) | (left ^ due_left))) | (over & !ended);
  const Walked<V> at_start{due.x, due.y, due.excess, V(0), due.excess, due.excess};
  return {select(first, at_start, n), Condition<V>((first & steps) | (wrong & !first))};
}

}  // namespace cosim::circular
