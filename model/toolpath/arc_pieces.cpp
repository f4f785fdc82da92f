#include "model/toolpath/arc_pieces.h"
#include "model/core/wide.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cosim::toolpath {

namespace {

Int128 cross(Point a, Point b) { return Int128{a.x} * b.y - Int128{a.y} * b.x; }
Int128 dot(Point a, Point b) { return Int128{a.x} * b.x + Int128{a.y} * b.y; }

// The quadrant of a vector other than (0, 0), each with the axis it starts from.
int quadrant_of(Point p) {
  if (p.x > 0 && p.y >= 0) return 0;
  if (p.x <= 0 && p.y > 0) return 1;
  return p.x < 0 ? 2 : 3;
}

// From the machine's frame to the plane: turned into quadrant `quadrant` (mod 4) and, for clockwise
// arcs, then mirrored in the x axis.
Orientation orientation_of(int quadrant, bool clockwise) {
  constexpr Orientation turned[] = {{1, 0, 0, 1}, {0, -1, 1, 0}, {-1, 0, 0, -1}, {0, 1, -1, 0}};
  Orientation o = turned[quadrant % 4];
  if (clockwise) {
    o.yu = static_cast<std::int8_t>(-o.yu);
    o.yv = static_cast<std::int8_t>(-o.yv);
  }
  return o;
}

// Rule 1, in the machine's frame of start's quadrant (x >= 1, y >= 0). Start is next to the circle
// where its resting coordinate v is nearest: (v - 1/2)^2 < radius2 - (the other)^2 < (v + 1/2)^2.
std::uint64_t fitted_radius2(Point start, Point end) {
  const Int128 of_start = dot(start, start);
  const Int128 mean = (of_start + dot(end, end) + 1) / 2;
  const Int128 v = std::max(start.x, start.y);
  return static_cast<std::uint64_t>(std::clamp(mean, of_start - v + 1, of_start + v));
}

// Rule 2 for two vectors from the centre as an anticlockwise arc sees them.
struct Turn {
  int borders = 0;       ///< the quadrant borders crossed; negative where the turn is
  bool forward = false;  ///< the turn is positive
};

Turn turn_between(Point start, Point end, double sweep) {
  const Int128 side = cross(start, end);
  int borders = (quadrant_of(end) - quadrant_of(start) + 4) % 4;
  if (borders == 0 && side < 0) borders = 4;
  const double angle = std::atan2(static_cast<double>(side), static_cast<double>(dot(start, end)));
  const double quantised = angle < 0 ? angle + 2 * std::numbers::pi : angle;
  const auto turns = static_cast<int>(std::lround((sweep - quantised) / (2 * std::numbers::pi)));
  borders += 4 * turns;
  return {borders, borders > 0 || (borders == 0 && side > 0)};
}

}  // namespace

ArcPieces arc_pieces(std::uint32_t segment, const GridArc& arc) {
  ArcPieces drawn;
  drawn.reached = arc.start;
  const Point start{arc.start.x - arc.centre.x, arc.start.y - arc.centre.y};
  const Point end{arc.end.x - arc.centre.x, arc.end.y - arc.centre.y};
  if (start == Point{} || end == Point{}) return drawn;

  const Orientation mirrored = orientation_of(0, arc.clockwise);
  const Point first = mirrored.to_machine(start);
  const Point last = mirrored.to_machine(end);
  const Turn turn = turn_between(first, last, arc.sweep);
  if (!turn.forward) return drawn;

  const int quadrant = quadrant_of(first);
  Point from = orientation_of(quadrant, arc.clockwise).to_machine(start);
  drawn.radius2 = fitted_radius2(from, end);
  const std::int64_t radius = circular::nearest_root(drawn.radius2);
  for (int i = 0; i < turn.borders; ++i) {
    const Orientation o = orientation_of(quadrant + i, arc.clockwise);
    drawn.pieces.push_back({segment, o, circular::Arc{from, drawn.radius2, std::nullopt}});
    from = {radius, 0};
  }

  const Orientation o = orientation_of(quadrant + turn.borders, arc.clockwise);
  const std::int64_t count = circular::steps_to(from, drawn.radius2, o.to_machine(end));
  if (count > 0) {
    circular::Arc part{from, drawn.radius2, count};
    if (count >= circular::steps_to_end(from, drawn.radius2)) part.count = std::nullopt;
    drawn.pieces.push_back({segment, o, part});
    from = point_after(from, drawn.radius2, count);
  }
  const Point reached = o.to_plane(from);
  drawn.reached = {arc.centre.x + reached.x, arc.centre.y + reached.y};
  return drawn;
}

Point point_after(Point from, std::uint64_t radius2, std::int64_t steps) {
  if (from.x > from.y) {
    // Every row of sector 1 takes a step; sector 2 begins on the first row with x <= y. As x never
    // grows, row from.x is one of those.
    std::int64_t row = from.y;
    std::int64_t change = from.x;
    while (change - row > 1) {
      const std::int64_t middle = row + (change - row) / 2;
      (circular::nearest_on(middle, radius2) > middle ? row : change) = middle;
    }
    if (steps < change - from.y) {
      return steps == 0 ? from
                        : Point{circular::nearest_on(from.y + steps, radius2), from.y + steps};
    }
    // That row may pass the circle by, as y = 2 with radius 2; but a step takes at most 1 from x.
    steps -= change - from.y;
    from = {std::clamp(circular::nearest_on(change, radius2), change - 1, change), change};
  }
  if (steps == 0) return from;
  return {from.x - steps, circular::nearest_on(from.x - steps, radius2)};
}

}  // namespace cosim::toolpath
