#include "model/toolpath/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "model/core/input_error.h"
#include "model/core/wide.h"
#include "model/toolpath/arc_pieces.h"

namespace cosim::toolpath {

namespace {

// The largest coordinate that the errors of a segment are differences of.
double magnitude(const Segment& s) {
  std::int64_t most = 0;
  for (const Point p : {s.start, s.end, s.centre}) {
    most = std::max({most, std::abs(p.x), std::abs(p.y)});
  }
  return std::max(static_cast<double>(most), std::sqrt(static_cast<double>(s.radius2)));
}

class Planner {
 public:
  Planner(const Program& program, double steps_per_mm) : program_(program), scale_(steps_per_mm) {}

  Plan run() {
    plan_.segments.reserve(program_.motions.size());
    for (const Motion& motion : program_.motions) add(motion);
    return std::move(plan_);
  }

 private:
  void add(const Motion& motion);
  void add_arc(const Motion& motion, Segment& segment);
  void add_line(Point from, Point to);
  Point grid_centre(const Motion& motion, const Segment& segment) const;
  double arc_quantisation(const Motion& motion, const Segment& segment) const;
  std::uint32_t number() const { return static_cast<std::uint32_t>(plan_.segments.size() + 1); }

  const Program& program_;
  double scale_;
  Plan plan_;
  Point position_;
};

void Planner::add(const Motion& motion) {
  const auto target = quantise(motion.end, scale_, max_coordinate);
  if (!target) {
    fail(program_.name, motion.place,
         "the target is beyond the reach of " + std::to_string(max_coordinate) + " steps");
  }
  Segment segment;
  segment.kind = motion.kind;
  segment.place = motion.place;
  segment.start = position_;
  segment.end = *target;
  segment.first_piece = plan_.pieces.size();
  segment.quantisation =
      std::max(distance(motion.start, scale_, position_), distance(motion.end, scale_, *target));
  if (is_arc(motion.kind)) add_arc(motion, segment);
  add_line(position_, *target);
  position_ = *target;
  segment.pieces = plan_.pieces.size() - segment.first_piece;
  // What the doubles' own rounding can make is no error of the grid.
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  if (segment.quantisation <= rounding * magnitude(segment)) segment.quantisation = 0;
  plan_.largest_closing = std::max(plan_.largest_closing, segment.closing);
  plan_.largest_quantisation = std::max(plan_.largest_quantisation, segment.quantisation);
  plan_.segments.push_back(segment);
}

// Leaves position_ where the arc's pieces end.
void Planner::add_arc(const Motion& motion, Segment& segment) {
  segment.centre = grid_centre(motion, segment);
  const bool clockwise = motion.kind == MotionKind::arc_cw;
  const ArcPieces arc =
      arc_pieces(number(), {segment.start, segment.end, segment.centre, clockwise, motion.sweep});
  plan_.pieces.insert(plan_.pieces.end(), arc.pieces.begin(), arc.pieces.end());
  position_ = arc.reached;
  segment.radius2 = arc.radius2;
  segment.closing =
      std::max(std::abs(segment.end.x - position_.x), std::abs(segment.end.y - position_.y));
  segment.quantisation = std::max(segment.quantisation, arc_quantisation(motion, segment));
  if (arc.radius2 != 0) {
    plan_.arc_width = std::max(plan_.arc_width, circular::width_needed(arc.radius2));
  }
}

void Planner::add_line(Point from, Point to) {
  if (from == to) return;
  plan_.pieces.push_back(line_piece(number(), from, to));
  plan_.longest_line = std::max(plan_.longest_line, steps(plan_.pieces.back()));
}

// Within max_radius of both ends, so that the squared radii stay below 2^64.
Point Planner::grid_centre(const Motion& motion, const Segment& segment) const {
  const auto in_reach = [](Point centre, Point p) {
    const Int128 x = p.x - centre.x;
    const Int128 y = p.y - centre.y;
    return x * x + y * y <= Int128{max_radius} * max_radius;
  };
  const auto centre = quantise(motion.centre, scale_, 2 * max_radius);
  if (!centre || !in_reach(*centre, segment.start) || !in_reach(*centre, segment.end)) {
    fail(program_.name, motion.place,
         "the arc's radius is beyond the reach of " + std::to_string(max_radius) + " steps");
  }
  return *centre;
}

double Planner::arc_quantisation(const Motion& motion, const Segment& segment) const {
  const auto radius_at = [&](PointMm p) {
    return scale_ * std::hypot(p.x - motion.centre.x, p.y - motion.centre.y);
  };
  const double at_start = radius_at(motion.start);
  const double at_end = radius_at(motion.end);
  const double larger = std::max(at_start, at_end);
  if (segment.radius2 == 0) {
    // No point of the exact arc is further from its start than the minimum.
    return segment.quantisation + std::min(2 * larger, larger * motion.sweep);
  }
  const double drawn = std::sqrt(static_cast<double>(segment.radius2));
  return distance(motion.centre, scale_, segment.centre) +
         std::max(std::abs(drawn - at_start), std::abs(drawn - at_end));
}

}  // namespace

Plan plan(const Program& program, double steps_per_mm) {
  if (!(std::isfinite(steps_per_mm) && steps_per_mm > 0)) {
    throw InputError("the number of steps per mm must be finite and above 0");
  }
  return Planner(program, steps_per_mm).run();
}

}  // namespace cosim::toolpath
