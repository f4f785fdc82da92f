#include "tb/studies/comparison/figures.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "model/circular/oracle.h"
#include "model/core/wide.h"
#include "model/linear/oracle.h"

namespace cosim::compare {

using prior_art::Point;

void Deviation::add(double one) {
  largest = std::max(largest, one);
  sum_of_squares += one * one;
  ++points;
}

void Deviation::add(const Deviation& other) {
  largest = std::max(largest, other.largest);
  sum_of_squares += other.sum_of_squares;
  points += other.points;
}

double Deviation::rms() const {
  return points == 0 ? 0 : std::sqrt(sum_of_squares / static_cast<double>(points));
}

void Figures::add(const Figures& other) {
  paths += other.paths;
  clocks += other.clocks;
  steps += other.steps;
  axial.add(other.axial);
  radial.add(other.radial);
  end_error = std::max(end_error, other.end_error);
  smallest_gap = std::min(smallest_gap, other.smallest_gap);
  largest_gap = std::max(largest_gap, other.largest_gap);
  combinations |= other.combinations;
}

int Figures::combinations_used() const { return std::popcount(combinations); }

namespace {

// Of numbers of 32 bits.
double area(const Line& line, Point at) {
  return static_cast<double>(Int128{line.major} * at.y - Int128{line.minor} * at.x);
}

double distance(Point a, Point b) {
  return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y));
}

double axial(const Line& line, Point at) {
  if (line.major == 0) return 0;
  return std::fabs(area(line, at)) / static_cast<double>(line.major);
}

// Where the row or column passes outside the circle, along the radius.
double axial(const Arc& arc, Point at) {
  const std::int64_t along = std::max(at.x, at.y), across = std::min(at.x, at.y);
  const auto rest = static_cast<std::int64_t>(arc.radius2) - across * across;
  if (rest < 0) return radial(arc, at);
  return std::fabs(static_cast<double>(along) - std::sqrt(static_cast<double>(rest)));
}

// What both kinds have in common. `gaps(p, q)`: whether the step from p to q ends a gap.
template <class Work, class Gaps>
Figures figures_of(const Work& work, const Points& points, std::uint64_t clocks, Point end,
                   double ideal, Gaps ends_gap) {
  Figures f;
  f.paths = 1;
  f.clocks = clocks;
  f.axial.add(axial(work, points.front()));
  f.radial.add(radial(work, points.front()));
  std::size_t last = 0;  // position of the step before; 0: none yet
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point &p = points[i - 1], &q = points[i];
    f.combinations |= 1U << ((p.x != q.x ? 1 : 0) + (p.y != q.y ? 2 : 0));
    if (p == q) continue;
    ++f.steps;
    f.axial.add(axial(work, q));
    f.radial.add(radial(work, q));
    if (!ends_gap(p, q)) continue;
    if (last != 0) {
      const double gap = static_cast<double>(i - last) / ideal;
      f.smallest_gap = std::min(f.smallest_gap, gap);
      f.largest_gap = std::max(f.largest_gap, gap);
    }
    last = i;
  }
  f.end_error = distance(points.back(), end);
  return f;
}

}  // namespace

double radial(const Line& line, Point at) {
  return linear::deviation(line.major, line.minor, at.x, at.y);
}

double radial(const Arc& arc, Point at) { return circular::radial_deviation(at, arc.radius2); }

Figures measured(const Line& line, const Points& points, std::uint64_t clocks) {
  const auto positions = static_cast<double>(points.size() - 1);
  return figures_of(line, points, clocks, {line.major, line.minor},
                    positions / static_cast<double>(std::max<std::int64_t>(line.minor, 1)),
                    [](Point p, Point q) { return p.y != q.y; });
}

Figures measured(const Arc& arc, const Points& points, std::uint64_t clocks) {
  std::size_t first = 0, last = 0, steps = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i] == points[i - 1]) continue;
    if (steps++ == 0) first = i;
    last = i;
  }
  const double mean =
      steps > 1 ? static_cast<double>(last - first) / static_cast<double>(steps - 1) : 1;
  return figures_of(arc, points, clocks, arc.to, mean, [](Point, Point) { return true; });
}

}  // namespace cosim::compare
