#include "tb/plot/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "model/core/input_error.h"
#include "tb/proof/process.h"

namespace cosim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_points = 500'000;
constexpr int panel_width = 460;  // of a path, in pixels
constexpr int columns = 3;        // of paths

// A single quote ends a text of gnuplot.
std::string plain(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\'') {
      safe += "''";
    } else if (c != '\n') {
      safe += c;
    }
  }
  return safe;
}

void add_data(std::string& script, const Plot& plot) {
  script += "$ideal << EOD\n";
  // Without a curve: the path's own start, for there has to be something.
  if (plot.ideal.empty()) {
    const circular::Point& at = plot.series.front().points.front();
    script += fmt::format("{} {}\n", at.x, at.y);
  }
  for (const auto& [x, y] : plot.ideal) script += fmt::format("{:.6g} {:.6g}\n", x, y);
  script += "EOD\n";
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& s = plot.series[i];
    script += fmt::format("$path{} << EOD\n", i);
    for (std::size_t k = 0; k < s.points.size(); ++k) {
      script += fmt::format("{} {} {:.5f}\n", s.points[k].x, s.points[k].y, s.deviations[k]);
    }
    script += "EOD\n";
  }
}

// The pixels that the tallest path needs in a panel, and whether its lattice can be shown.
struct Extent {
  int height = 0;
  bool small = false;
};

Extent extent_of(const Plot& plot) {
  std::int64_t x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  for (const Series& s : plot.series) {
    for (const auto& p : s.points) {
      x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y),
      y1 = std::max(y1, p.y);
    }
  }
  const double wide = std::max<double>(1, static_cast<double>(x1 - x0));
  const double ratio = static_cast<double>(y1 - y0) / wide;
  return {std::clamp(static_cast<int>(panel_width * 0.75 * ratio) + 90, 150, 420),
          std::max(x1 - x0, y1 - y0) <= 30};
}

std::string script_of(const std::string& path, const Plot& plot) {
  const auto panels = static_cast<int>(plot.series.size());
  const int wide = std::min(panels, columns), high = (panels + columns - 1) / columns;
  const int width = std::max(wide * panel_width, 640);
  constexpr int curve = 240, heading = 40;
  const Extent extent = extent_of(plot);
  const int height = high * extent.height + curve + heading;

  std::string script = fmt::format(
      "set terminal {} size {},{} font 'DejaVu Sans,10' noenhanced\nset output '{}'\n",
      path.ends_with(".svg") ? "svg background 'white'" : "pngcairo", width, height, plain(path));
  add_data(script, plot);
  script += fmt::format("set multiplot title '{}'\n", plain(plot.title));
  // One scale of colours for all pictures: half a step and a step are what one looks for.
  script +=
      "set palette defined (0 '#1a9850', 0.5 '#fdae61', 1 '#d73027', 2 '#762a83')\n"
      "set cbrange [0:2]\nset cblabel 'steps off'\nset grid lt 1 lc rgb '#d0d0d0'\nunset key\n";
  if (extent.small) script += "set xtics 1 format ''\nset ytics 1 format ''\n";
  const double below = static_cast<double>(curve) / height;
  const double one = (1 - below - static_cast<double>(heading) / height) / high;
  for (int i = 0; i < panels; ++i) {
    const std::size_t points = plot.series[static_cast<std::size_t>(i)].points.size();
    const double size = points < 60 ? 1.1 : points < 200 ? 0.7 : points < 1000 ? 0.4 : 0.2;
    script += fmt::format(
        "set size ratio -1\nset origin {:.4f},{:.4f}\nset size {:.4f},{:.4f}\nset title '{}'\n"
        "plot $ideal using 1:2 with lines lw 1.2 lc rgb '#4575b4', "
        "$path{} using 1:2 with lines lw 0.8 lc rgb '#999999', "
        "$path{} using 1:2:3 with points pt 7 ps {} lc palette\n",
        static_cast<double>(i % columns) / wide, below + one * (high - 1 - i / columns), 1.0 / wide,
        one, plain(plot.series[static_cast<std::size_t>(i)].name), i, i, size);
  }
  script += fmt::format(
      "set size noratio\nset origin 0,0\nset size 1,{:.4f}\nset title 'how far off, in steps, "
      "along the path'\nset key outside right\nset xrange [0:1]\nset yrange [0:*]\n"
      "set xtics auto format '%.1f'\nset ytics auto format '%.1f'\nplot ",
      below);
  for (int i = 0; i < panels; ++i) {
    const Series& s = plot.series[static_cast<std::size_t>(i)];
    script +=
        fmt::format("{}$path{} using ($0/{}):3 with lines lw 1.4 title '{}'", i == 0 ? "" : ", ", i,
                    std::max<std::size_t>(s.points.size(), 2) - 1, plain(s.name));
  }
  return script + "\nunset multiplot\n";
}

}  // namespace

std::vector<std::pair<double, double>> ideal_line(circular::Point to) {
  return {{0, 0}, {static_cast<double>(to.x), static_cast<double>(to.y)}};
}

std::vector<std::pair<double, double>> ideal_arc(double radius, circular::Point from,
                                                 circular::Point to) {
  constexpr int pieces = 256;
  const auto angle = [](circular::Point p) {
    return std::atan2(static_cast<double>(p.y), static_cast<double>(p.x));
  };
  std::vector<std::pair<double, double>> all;
  for (int i = 0; i <= pieces; ++i) {
    const double at = angle(from) + (angle(to) - angle(from)) * i / pieces;
    all.emplace_back(radius * std::cos(at), radius * std::sin(at));
  }
  return all;
}

void check_plot(const std::string& path) {
  const fs::path file(path);
  if ((file.extension() != ".svg" && file.extension() != ".png") || file.stem().empty()) {
    throw InputError(fmt::format("--plot: {} does not end in .svg or .png", path));
  }
  if (proof::run_program({"gnuplot", "--version"}).status != 0) {
    throw InputError("--plot: needs gnuplot, which is not installed (apt-get install gnuplot-nox)");
  }
}

void draw_plot(const std::string& path, const Plot& plot) {
  std::size_t points = 0;
  for (const Series& s : plot.series) points += s.points.size();
  if (points > most_points) {
    throw InputError(
        fmt::format("--plot: {} points are too many to draw, at most {}", points, most_points));
  }
  const proof::Scratch scratch;
  const std::string script = scratch.path() / "plot.gp";
  std::ofstream(script) << script_of(path, plot);
  const auto ended = proof::run_program({"gnuplot", script});
  if (ended.status != 0) throw InputError(fmt::format("--plot: {}: gnuplot failed", path));
}

}  // namespace cosim
