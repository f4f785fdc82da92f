// Pictures by gnuplot: paths on the grid over the ideal curve, and how far they are off it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/circular/arc.h"

namespace cosim {

/// One path: a point and how far it is off the curve, in steps, for each step.
struct Series {
  std::string name;
  std::vector<circular::Point> points;
  std::vector<double> deviations;

  void add(circular::Point at, double deviation) {
    points.push_back(at);
    deviations.push_back(deviation);
  }
};

struct Plot {
  std::string title;
  std::vector<std::pair<double, double>> ideal;  ///< the curve, as a polyline
  std::vector<Series> series;                    ///< side by side, at least one
};

/// The points of an ideal line, from (0, 0) to `to`, and of an arc about (0, 0).
std::vector<std::pair<double, double>> ideal_line(circular::Point to);
std::vector<std::pair<double, double>> ideal_arc(double radius, circular::Point from,
                                                 circular::Point to);

/// InputError where `path` does not end in .svg or .png, and where there is no gnuplot.
void check_plot(const std::string& path);

/// Draws it into the file. InputError where gnuplot fails, or there are more points than it can
/// show, 500,000.
void draw_plot(const std::string& path, const Plot& plot);

}  // namespace cosim
