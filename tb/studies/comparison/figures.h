// What is measured of a path, whatever drew it.
#pragma once

#include <cstdint>
#include <limits>

#include "model/prior_art/work.h"

namespace cosim::compare {

using prior_art::Arc;
using prior_art::Line;
using prior_art::Points;

/// How far points are off their curve, in steps.
struct Deviation {
  double largest = 0;
  double sum_of_squares = 0;
  std::uint64_t points = 0;

  void add(double one);
  void add(const Deviation& other);
  double rms() const;
};

/// The figures of one path or, added up, of several. A point counts once: positions without a step
/// add nothing.
struct Figures {
  std::uint64_t paths = 0;
  std::uint64_t clocks = 0;  ///< from the start to the end of the drawing
  std::uint64_t steps = 0;   ///< positions on which an axis steps
  /// Of a line along its minor axis, of an arc along the axis that rests: x where x > y, else y.
  Deviation axial;
  /// Of a line across it, of an arc along the radius.
  Deviation radial;
  double end_error = 0;  ///< the largest distance of a last point from the end asked for
  /// The smallest and the largest number of positions from one step to the next over the ideal one:
  /// of a line, steps of the minor axis and all positions over the minor length; of an arc, steps
  /// of any axis and their mean. Without a gap smallest > largest.
  double smallest_gap = std::numeric_limits<double>::infinity();
  double largest_gap = 0;
  /// The combinations of steps seen on a position: bit 0 none, 1 x alone, 2 y alone, 3 both.
  unsigned combinations = 0;

  void add(const Figures& other);
  int combinations_used() const;
};

Figures measured(const Line& line, const Points& points, std::uint64_t clocks);
Figures measured(const Arc& arc, const Points& points, std::uint64_t clocks);

/// The deviations of one point; they are the figures' own.
double radial(const Line& line, plane::Point at);
double radial(const Arc& arc, plane::Point at);

}  // namespace cosim::compare
