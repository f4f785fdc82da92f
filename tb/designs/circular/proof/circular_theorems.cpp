// SU 1665343 on integers without end: every radius and every width. Q is R^2, an integer.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <cosim/model.h>

#include "model/circular/job.h"
#include "model/circular/view.h"
#include "tb/designs/circular/proof/points.h"
#include "tb/designs/circular/proof/theorems.h"
#include "tb/proof/unbounded.h"

namespace cosim::circular::on_integers {
namespace {
using namespace proof::unbounded;
#include "model/circular/circular.h"
}  // namespace
}  // namespace cosim::circular::on_integers

namespace cosim::circular {
namespace {

using namespace proof;

using IntegerPoint = ArcPoint<Integer>;
using State = Numbers<Integer>;
constexpr std::size_t f = 2, ct7 = 3, ct8 = 4;

struct Step {
  State state;
  Integer step_x, step_y;
};

// The circle crosses the point's row, or column, less than half a step away: (x - 1/2)^2 < R^2 -
// y^2 < (x + 1/2)^2, which on integers is -x < d <= x.
Truth nearest(const Integer& resting, const Integer& d) {
  return (Integer(0) - resting < d) & (d <= resting);
}
Truth nearest_in_row(const IntegerPoint& p) { return nearest(p.x, p.d); }
Truth nearest_in_column(const IntegerPoint& p) { return nearest(p.y, p.d); }

Truth same(const State& a, const State& b) {
  Truth all = true;
  for (std::size_t i = 0; i < a.size(); ++i) all = all & (a[i] == b[i]);
  return all;
}

// One question: the free integers, what is assumed, what must follow.
class Proposition : public Script {
 public:
  Theorem follows(const std::string& sentence, const Truth& t) const {
    return {"circular", sentence, OnIntegers{asked(!t), asked(true)}};
  }

  const IntegerPoint p{integer("X"), integer("Y"), integer("D")};
  /// D, where the radius matters and not only the distance from it.
  Integer d_of(const Integer& q) const { return q - p.x * p.x - p.y * p.y; }
  /// One clock of the golden model with all pins at rest. Its width plays no part.
  Step clock(const State& s) {
    using Machine = on_integers::Circular<16>;
    namespace u = unbounded;
    const auto all = u::ways.joined([&] {
      Machine m{.t4 = u::Bit(s[0] == Integer(1)),
                .t16 = u::Bit(s[1] == Integer(1)),
                .f = u::Number(s[f]),
                .ct7 = u::Number(s[ct7]),
                .ct8 = u::Number(s[ct8])};
      const auto out = m.clock({});
      return std::array<Integer, 7>{u::Number(m.t4).integer,
                                    u::Number(m.t16).integer,
                                    m.f.integer,
                                    m.ct7.integer,
                                    m.ct8.integer,
                                    u::Number(out.step_x).integer,
                                    u::Number(out.step_y).integer};
    });
    return {{all[0], all[1], all[2], all[3], all[4]}, all[5], all[6]};
  }
  /// The point after the steps that the clock puts out; distance() proves its d.
  IntegerPoint moved(const Step& step) const {
    const Truth left = step.step_x == Integer(1), up = step.step_y == Integer(1);
    const Integer zero(0), one(1);
    return {p.x - step.step_x, p.y + step.step_y,
            p.d + select(left, p.x + p.x - one, zero) - select(up, p.y + p.y + one, zero)};
  }
};

Theorem distance() {
  Proposition a;
  const Integer q = a.integer("Q"), i = a.integer("i"), j = a.integer("j"), zero(0), one(1);
  a.assume((i >= zero) & (i <= one) & (j >= zero) & (j <= one) & (a.p.d == a.d_of(q)));
  Step step;
  step.step_x = i;
  step.step_y = j;
  const IntegerPoint next = a.moved(step);
  return a.follows(
      "a step changes D = Q - X^2 - Y^2 by 2X - 1 where X falls and by -2Y - 1 where Y rises",
      next.d == q - next.x * next.x - next.y * next.y);
}

Theorem start() {
  Proposition a;
  const Integer r = a.integer("R");
  a.assume((r >= Integer(1)) & (a.p.d == a.d_of(r * r)) & (a.p.x == r) & (a.p.y == Integer(0)));
  return a.follows("(R, 0) is nearest in its row, for every R >= 1", nearest_in_row(a.p));
}

Theorem sector1() {
  Proposition a;
  a.assume((a.p.y >= Integer(0)) & (a.p.x > a.p.y) & nearest_in_row(a.p));
  const auto step = a.clock(in_sector1(a.p));
  const IntegerPoint next = a.moved(step);
  return a.follows(
      "in sector 1 a point nearest in its row is followed by the one nearest in the next row, or "
      "past the diagonal in its column; F, CT7 and CT8 are those of the new point",
      (step.step_y == Integer(1)) & same(step.state, in_sector1(next)) &
          implies(next.x > next.y, nearest_in_row(next)) &
          implies(next.x <= next.y, nearest_in_column(next) & (next.x >= next.y - Integer(1))));
}

Theorem change() {
  Proposition a;
  a.assume((a.p.y >= Integer(0)) & (a.p.x <= a.p.y) & (a.p.x >= a.p.y - Integer(1)) &
           nearest_in_column(a.p));
  const auto step = a.clock(in_sector1(a.p));
  return a.follows(
      "the change to sector 2, which moves nothing, has F, CT7 and CT8 of sector 2 at this point",
      (step.step_x == Integer(0)) & (step.step_y == Integer(0)) &
          same(step.state, in_sector2(a.p)));
}

Theorem sector2() {
  Proposition a;
  a.assume((a.p.x >= Integer(1)) & (a.p.y >= a.p.x) & nearest_in_column(a.p));
  const auto step = a.clock(in_sector2(a.p));
  const IntegerPoint next = a.moved(step);
  return a.follows(
      "in sector 2 a point nearest in its column is followed by the one nearest in the next "
      "column; F, CT7 and CT8 are those of the new point",
      (step.step_x == Integer(1)) & same(step.state, in_sector2(next)) & (next.y >= next.x) &
          nearest_in_column(next));
}

Theorem steps() {
  Proposition a;
  a.assume((a.p.y >= Integer(0)) & (a.p.x >= Integer(0)));
  const Integer sector = a.integer("sector");
  a.assume((sector == Integer(1)) | (sector == Integer(2)));
  State s = in_sector2(a.p);
  const State first = in_sector1(a.p);
  for (std::size_t i = 0; i < s.size(); ++i) s[i] = select(sector == Integer(1), first[i], s[i]);
  const auto step = a.clock(s);
  const Integer zero(0), one(1);
  return a.follows(
      "a clock moves a unit, or a diagonal, or not at all: never back, never further",
      (step.step_x >= zero) & (step.step_x <= one) & (step.step_y >= zero) & (step.step_y <= one));
}

Theorem last_point() {
  Proposition a;
  const Integer r = a.integer("R");
  a.assume((r >= Integer(1)) & (a.p.y >= Integer(0)) & nearest(a.p.y, r * r - a.p.y * a.p.y));
  return a.follows("of the column X = 0 only (0, R) is nearest", a.p.y == r);
}

Theorem end() {
  Proposition a;
  a.assume((a.p.x == Integer(0)) & (a.p.y >= Integer(0)));
  const auto step = a.clock(in_sector2(a.p));
  const State at_rest{Integer(0), Integer(0), Integer(3), Integer(0), Integer(0)};
  return a.follows(
      "on X = 0 the arc ends: the machine clears itself and moves no more",
      (step.step_x == Integer(0)) & (step.step_y == Integer(0)) & same(step.state, at_rest));
}

Theorem progress1() {
  Proposition a;
  a.assume((a.p.y >= Integer(0)) & (a.p.x > a.p.y));
  const State before = in_sector1(a.p);
  return a.follows("sector 1 ends: CT8 falls on each of its steps",
                   a.clock(before).state[ct8] < before[ct8]);
}

Theorem progress2() {
  Proposition a;
  a.assume((a.p.x >= Integer(1)) & (a.p.y >= a.p.x));
  const State before = in_sector2(a.p);
  return a.follows("sector 2 ends: CT7 falls on each of its steps",
                   a.clock(before).state[ct7] < before[ct7]);
}

// Of the nearer coordinate of the two; where that is the row's the other one is less, or more by
// one.
Theorem extent() {
  Proposition a;
  const Integer m = a.integer("M"), zero(0);
  a.assume((m >= Integer(1)) & (a.p.x >= zero) & (a.p.y >= zero));
  a.assume(a.p.x * a.p.x - a.p.x + a.p.y * a.p.y < m * m - m);
  return a.follows(
      "where R < M - 1/2, no point that is nearest in its row has X >= M; Y and columns likewise",
      a.p.x < m);
}

// M is 2^W. The largest number of CT7 and CT8 is M - 1, that of F in quarters 8 M - 1.
Theorem bounds() {
  Proposition a;
  const Integer m = a.integer("M"), zero(0), one(1);
  a.assume((m >= Integer(4)) & (a.p.x >= zero) & (a.p.x < m) & (a.p.y >= zero) & (a.p.y < m));
  const auto fits = [&](const State& s) {
    const auto within = [](const Integer& v, const Integer& most) {
      return (v <= most) & (v >= Integer(0) - most);
    };
    return within(s[ct7], m - one) & within(s[ct8], m - one) & within(s[f], Integer(8) * m - one);
  };
  const Truth first = nearest_in_row(a.p) & (a.p.x > a.p.y);
  const Truth change = nearest_in_column(a.p) & (a.p.x <= a.p.y) & (a.p.x >= a.p.y - one);
  const Truth second = nearest_in_column(a.p) & (a.p.x <= a.p.y);
  return a.follows(
      "no register overflows: for every width W >= 2 and M = 2^W, at every such point CT7 and CT8 "
      "fit into W + 1 bits of ones' complement and F into W + 4",
      implies(first | change, fits(in_sector1(a.p))) & implies(second, fits(in_sector2(a.p))));
}

}  // namespace

std::vector<proof::Theorem> circle_theorems() {
  return {distance(),  start(),     sector1(),    change(), sector2(), steps(),
          progress1(), progress2(), last_point(), end(),    extent(),  bounds()};
}

}  // namespace cosim::circular
