// The check of a curve, see model/core/job.h: Track of oracle.h, whose rates
// are those of the point that it stands on. It knows the left side of the curve's equation there,
// too.
#pragma once

#include "model/dda/drive.h"

namespace cosim::dda {

// clang-format off
/// Where it stands. Nothing of it wraps on the way of a job that is one.
#define DDA_CHECKER(FIELD)                                                                         \
  FIELD(shifts,  6,                   number,          "", "clocks to come that shift")            \
  FIELD(left,    clock_bits(p.width), number,          "", "clocks to come until the stop")        \
  FIELD(over,    1,                   flag,            "", "it has come to the end")               \
  FIELD(sum_x,   p.width,             number,          "", "the sum of the rates, its part of a step") \
  FIELD(sum_y,   p.width,             number,          "", "")                                     \
  FIELD(rate_x,  p.width + 2,         twos_complement, "", "at the point")                         \
  FIELD(rate_y,  p.width + 2,         twos_complement, "", "")                                     \
  FIELD(x,       p.width + 2,         twos_complement, "", "the point")                            \
  FIELD(y,       p.width + 2,         twos_complement, "", "")                                     \
  FIELD(left_x,  p.width,             number,          "", "steps to come")                        \
  FIELD(left_y,  p.width,             number,          "", "")                                     \
  FIELD(excess,  p.width + 10,        twos_complement, "", "twice the equation's left side, shifted") \
  FIELD(steps,   clock_bits(p.width), number,          "", "clocks with a step so far")            \
  FIELD(least,   p.width + 10,        twos_complement, "", "excess of this job")                   \
  FIELD(most,    p.width + 10,        twos_complement, "", "")
// clang-format on

COSIM_RECORD(Checker, DDA_CHECKER, Params);

Checker<Word> checker_of(const Params& p, const Job& job);
/// How many clocks shift its rates.
int shifts_of(const Params& p, const Job& job);

/// Wrong is a step, a code or the end.
template <class V>
constexpr Verdict<Checker, V> checked(const Params& p, const Task<V>& t, const Driver<V>&,
                                      const Checker<V>& w, const Outputs<V>& seen,
                                      Condition<V> over) {
  const Condition<V> busy = is_set(seen.busy), counted = !bit(t.words[0], 2);
  const Condition<V> sequential = bit(t.words[0], 0);
  const auto code = [&](const V& v) { return from_twos_complement(v, p.width + 1); };
  const V two_a = code(t.words[9]), b = code(t.words[10]), two_c = code(t.words[11]);
  const auto times = [](const V& step, const V& by) {
    return select(step == V(0), V(0), select(step < V(0), V(0) - by, by));
  };

  const Condition<V> ended =
      (counted & (w.left_x == V(0)) & (w.left_y == V(0))) | (is_set(t.counted) & (w.left == V(0)));
  const Condition<V> draws = busy & !ended, shifts = draws & !(w.shifts == V(0));
  const Condition<V> moves = draws & !shifts;
  const V to_x = w.sum_x + w.rate_x;
  const V x = select(moves & !(counted & (w.left_x == V(0))), shift_right(to_x, p.width), V(0));
  const V turned_y = w.rate_y + times(x, two_a), turned_x = w.rate_x - times(x, b);
  const V to_y = w.sum_y + select(sequential, turned_y, w.rate_y);
  const V y = select(moves & !(counted & (w.left_y == V(0))), shift_right(to_y, p.width), V(0));
  const auto size = [](const V& step) { return select(step < V(0), V(0) - step, step); };

  Checker<V> n = w;
  n.shifts = w.shifts - flag<V>(shifts);
  n.left = w.left - flag<V>(busy & !(w.left == V(0)));
  n.over = select(busy, flag<V>(ended), w.over);
  n.sum_x = select(moves, low_bits(to_x, p.width), w.sum_x);
  n.sum_y = select(moves, low_bits(to_y, p.width), w.sum_y);
  n.rate_x = select(shifts, w.rate_x + w.rate_x, turned_x - times(y, two_c));
  n.rate_y = select(shifts, w.rate_y + w.rate_y, turned_y + times(y, b));
  n.x = w.x + x;
  n.y = w.y + y;
  n.left_x = w.left_x - size(x);
  n.left_y = w.left_y - size(y);
  // A step along x changes the left side by y' at its middle, one along y by -x'.
  n.excess = w.excess + times(x, shift_left(w.rate_y, 1)) + select(x == V(0), V(0), two_a) -
             times(y, shift_left(turned_x, 1)) + select(y == V(0), V(0), two_c);
  n.steps = w.steps + flag<V>(!((x == V(0)) & (y == V(0))));
  n.least = select(n.excess < w.least, n.excess, w.least);
  n.most = select(n.excess > w.most, n.excess, w.most);

  const Condition<V> right = (seen.x_up - seen.x_down == x) & (seen.y_up - seen.y_down == y) &
                             (code(seen.code_x) == w.x) & (code(seen.code_y) == w.y);
  const Condition<V> wrong = (busy & !right) | (over & !is_set(w.over));
  return {n, wrong};
}

}  // namespace cosim::dda
