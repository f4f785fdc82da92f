// Pictures by gnuplot: paths on the grid over the ideal curve, and how far they are off it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cosim {

/// A curve as a polyline, in steps.
using Curve = std::vector<std::pair<double, double>>;

/// A point of the grid.
struct GridPoint {
  std::int64_t x = 0, y = 0;
};

/// A point of a path.
struct Mark {
  GridPoint at;
  double off = 0;    ///< its distance from the curve, in steps
  double along = 0;  ///< where it lies on the path, in steps from its start
};

/// One path. Marks are in the order they were drawn.
/// Only neighbours on the grid are joined.
struct Series {
  static constexpr std::size_t most_marks = 1'000'000;

  std::string name;
  std::vector<Mark> marks;  ///< at least one

  /// InputError if a path of so many steps is too long for a picture.
  static void check_steps(std::uint64_t steps);
  /// InputError if there are too many.
  void add(const Mark& mark);
  /// The next step of a path that is drawn step by step.
  void add(GridPoint at, double off) { add({at, off, static_cast<double>(marks.size())}); }
};

struct Plot {
  std::string title;
  std::vector<Curve> ideal;    ///< what was to be drawn
  std::vector<Series> series;  ///< side by side, at least one
};

/// InputError where there is no gnuplot.
void check_plot();

/// Draws it into the file, whose name ends in .svg or .png. InputError where gnuplot fails.
void draw_plot(const std::string& path, const Plot& plot);

}  // namespace cosim
