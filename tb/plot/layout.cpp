#include "tb/plot/layout.h"

#include <algorithm>
#include <cmath>

namespace cosim {
namespace {

constexpr int heading = 54, title = 34, left = 48, right = 14, tics = 32, label = 22;
constexpr int colours_room = 90;

// All points and a margin.
void show_all(Layout& all, const Plot& plot) {
  const auto take = [&](double x, double y) {
    all.x0 = std::min(all.x0, x), all.x1 = std::max(all.x1, x);
    all.y0 = std::min(all.y0, y), all.y1 = std::max(all.y1, y);
  };
  const GridPoint first = plot.series.front().marks.front().at;
  all.x0 = all.x1 = static_cast<double>(first.x);
  all.y0 = all.y1 = static_cast<double>(first.y);
  double worst = 0;
  for (const Series& s : plot.series) {
    for (const Mark& m : s.marks) {
      take(static_cast<double>(m.at.x), static_cast<double>(m.at.y));
      all.length = std::max(all.length, m.along);
      worst = std::max(worst, m.off);
    }
  }
  for (const Curve& curve : plot.ideal) {
    for (const auto& [x, y] : curve) take(x, y);
  }
  const double margin = std::max(0.7, 0.03 * std::max(all.x1 - all.x0, all.y1 - all.y0));
  all.x0 -= margin, all.x1 += margin, all.y0 -= margin, all.y1 += margin;
  all.top = std::clamp(std::ceil(worst * 2) / 2, 0.5, worst_shown);
}

// The height of the paths, and more of the grid where they would be too flat or too high.
void shape_paths(Layout& all) {
  const int least = 60, most = all.columns == 1 ? all.path.width * 4 / 5 : all.path.width * 6 / 5;
  const double wide = all.x1 - all.x0, high = all.y1 - all.y0;
  all.path.height = static_cast<int>(std::clamp<double>(all.path.width * high / wide, least, most));
  const double a_pixel = std::max(wide / all.path.width, high / all.path.height);
  const double more_x = (a_pixel * all.path.width - wide) / 2;
  const double more_y = (a_pixel * all.path.height - high) / 2;
  all.x0 -= more_x, all.x1 += more_x, all.y0 -= more_y, all.y1 += more_y;
}

}  // namespace

Box Layout::in(int panel, Box box) const {
  box.x += panel % columns * panel_width;
  box.y += panel / columns * panel_height;
  return box;
}

Layout layout_of(const Plot& plot) {
  const auto panels = static_cast<int>(plot.series.size());
  Layout all;
  all.columns = panels <= 3 ? panels : panels == 4 ? 2 : panels <= 6 ? 3 : 4;
  all.panel_width = all.columns == 1 ? 800 : all.columns <= 3 ? 400 : 320;
  show_all(all, plot);
  all.path = {left, heading + title, all.panel_width - left - right, 0};
  shape_paths(all);
  all.bars = {left, all.path.y + all.path.height + tics, all.path.width,
              all.columns == 1 ? 120 : 70};
  all.panel_height = title + all.path.height + tics + all.bars.height + tics + label;
  all.width = all.columns * all.panel_width + colours_room;
  all.height = heading + (panels + all.columns - 1) / all.columns * all.panel_height;
  all.colours = {all.width - colours_room + 8, all.path.y, 16,
                 std::min(all.path.height + tics + all.bars.height, 420)};
  return all;
}

}  // namespace cosim
