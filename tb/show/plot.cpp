#include "tb/show/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iosfwd>
#include <map>
#include <ostream>
#include <string>

#include "model/core/input_error.h"
#include "tb/util/finite.h"
#include "tb/util/output_file.h"
#include "tb/util/process.h"
#include "tb/util/quoted.h"
#include "tb/util/read_file.h"

namespace cosim {
namespace {

// A picture as a script of gnuplot, with its data in it.

// Where everything stands in a picture, in pixels from its upper left corner.
/// Colours and bars show no difference above this deviation, in steps.
constexpr double worst_shown = 2;

struct Box {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Panels side by side, all alike and on the same scales: a path, and below it the bars of its
/// deviations.
struct Layout {
  int columns = 0;
  int width = 0;  ///< of the picture
  int height = 0;
  Box path;     ///< of the first panel
  Box bars;     ///< likewise
  Box colours;  ///< the scale of colours
  int panel_width = 0;
  int panel_height = 0;

  double x0 = 0, x1 = 0, y0 = 0, y1 = 0;  ///< the part of the grid that is shown; a step is square
  double length = 1;                      ///< of the longest path, in steps
  double top = 0;                         ///< of the bars, in steps: 0.5 to worst_shown

  /// The place of a box of the first panel in another panel.
  Box in(int panel, Box box) const;
  double pixels_a_step() const { return path.width / (x1 - x0); }
};

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

// Whether single points of the grid can be told apart; then they are joined as they were drawn.
bool shows_steps(const Layout& all) { return all.pixels_a_step() >= 6; }

// The cell of a picture that a mark falls into.
using Cell = std::function<std::pair<std::int64_t, std::int64_t>(const Mark&)>;

// Of each cell the mark that is furthest off, in ascending order: the worst are drawn last and stay
// visible.
std::vector<Mark> worst_of_cells(const std::vector<Mark>& marks, const Cell& cell) {
  std::map<std::pair<std::int64_t, std::int64_t>, Mark> worst;
  for (const Mark& mark : marks) {
    const auto [at, added] = worst.try_emplace(cell(mark), mark);
    if (!added && mark.off > at->second.off) at->second = mark;
  }
  std::vector<Mark> kept;
  kept.reserve(worst.size());
  for (const auto& [key, mark] : worst) kept.push_back(mark);
  std::ranges::stable_sort(kept, {}, &Mark::off);
  return kept;
}

void write_marks(std::ostream& out, const std::string& name, const std::vector<Mark>& marks) {
  out << '$' << name << " << EOD\n";
  for (const Mark& m : marks) {
    out << fmt::format("{} {} {:.4f} {:.6g}\n", m.at.x, m.at.y, m.off, m.along);
  }
  out << "EOD\n";
}

// An empty line ends what is joined.
void write_joined(std::ostream& out, int panel, const std::vector<Mark>& marks) {
  out << "$way" << panel << " << EOD\n";
  GridPoint last = marks.front().at;
  for (const Mark& m : marks) {
    if (std::abs(m.at.x - last.x) > 1 || std::abs(m.at.y - last.y) > 1) out << '\n';
    out << m.at.x << ' ' << m.at.y << '\n';
    last = m.at;
  }
  out << "EOD\n";
}

void write_data(std::ostream& out, const Plot& plot, const Layout& all) {
  out << "$ideal << EOD\n";
  for (const Curve& curve : plot.ideal) {
    for (const auto& [x, y] : curve) out << fmt::format("{:.8g} {:.8g}\n", x, y);
    out << '\n';
  }
  out << "EOD\n";
  const auto pixel = [&](double value) { return static_cast<std::int64_t>(std::floor(value)); };
  const double scale = all.pixels_a_step() / 1.5;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const std::vector<Mark>& marks = plot.series[i].marks;
    write_marks(out, fmt::format("spots{}", i), worst_of_cells(marks, [&](const Mark& m) {
                  return std::pair(pixel(static_cast<double>(m.at.x) * scale),
                                   pixel(static_cast<double>(m.at.y) * scale));
                }));
    write_marks(out, fmt::format("bars{}", i), worst_of_cells(marks, [&](const Mark& m) {
                  return std::pair(pixel(m.along / all.length * all.bars.width), std::int64_t{0});
                }));
    if (shows_steps(all)) write_joined(out, static_cast<int>(i), marks);
  }
}

std::string margins(const Layout& all, const Box& box) {
  const double wide = all.width, high = all.height;
  return fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
      "set tmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n",
      box.x / wide, (box.x + box.width) / wide, 1 - box.y / high, 1 - (box.y + box.height) / high);
}

double worst_of(const Plot& plot) {
  double worst = 0;
  for (const Series& s : plot.series) {
    for (const Mark& m : s.marks) worst = std::max(worst, m.off);
  }
  return worst;
}

std::string title_of(const Series& series) {
  double largest = 0, squares = 0;
  for (const Mark& m : series.marks) {
    largest = std::max(largest, m.off);
    squares += m.off * m.off;
  }
  return fmt::format("{}: max {:.3f}, RMS {:.3f}", series.name, largest,
                     std::sqrt(squares / static_cast<double>(series.marks.size())));
}

// 1, 2 or 5 times a power of ten, at most so many of them in a range.
double tic(double range, double most) {
  const double least = range / most, ten = std::pow(10, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0}) {
    if (times * ten >= least) return std::max(1.0, times * ten);
  }
  return std::max(1.0, 10 * ten);
}

void write_path(std::ostream& out, const Plot& plot, const Layout& all, int panel) {
  const double between = tic(all.x1 - all.x0, all.path.width / 40.0);
  out << margins(all, all.in(panel, all.path))
      << fmt::format("set title {}\n",
                     for_gnuplot(title_of(plot.series[static_cast<std::size_t>(panel)])))
      << fmt::format("set xrange [{:.6f}:{:.6f}]\nset yrange [{:.6f}:{:.6f}]\n", all.x0, all.x1,
                     all.y0, all.y1)
      << fmt::format("unset xlabel\nset xtics {0}\nset ytics {0}\n", between);
  if (shows_steps(all)) out << fmt::format("set mxtics {0}\nset mytics {0}\n", between);
  out << "plot ";
  if (!plot.ideal.empty()) out << "$ideal using 1:2 with lines lw 1 lc rgb '#555555', ";
  if (shows_steps(all)) {
    out << fmt::format("$way{} using 1:2 with lines lw 0.8 lc rgb '#999999', ", panel);
  }
  out << fmt::format("$spots{} using 1:2:3 with points pt 7 ps {:.2f} lc palette\n", panel,
                     std::clamp(all.pixels_a_step() / 16, 0.25, 1.1));
}

void write_bars(std::ostream& out, const Plot& plot, const Layout& all, int panel) {
  const auto marks = static_cast<double>(plot.series[static_cast<std::size_t>(panel)].marks.size());
  const double bars = std::max(marks, all.length);
  const bool few = bars < 100;
  const double bar = all.length / std::min<double>(bars, all.bars.width);
  const double margin = std::max(0.5, 0.01 * all.length);
  out << margins(all, all.in(panel, all.bars))
      << fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", -margin, all.length + margin,
                     -0.1 * all.top, all.top)
      << "unset title\nunset mxtics\nunset mytics\n"
      << fmt::format("set ytics {}\nset xtics {}\n", all.top > 1.5 ? 1 : 0.5,
                     tic(all.length, all.bars.width / 60.0))
      << "set xlabel 'step along the path' offset 0,0.6\n"
      // The dots tell points without a deviation from those that are not drawn.
      << fmt::format(
             "plot $bars{0} using 4:($3 > {1} ? {1} : $3):({2}):3 with boxes lc palette, "
             "$bars{0} using 4:({3}):3 with points pt 7 ps {4} lc palette, "
             "0.5 with lines dt 2 lw 0.8 lc rgb '#555555'\n",
             panel, all.top, few ? 0.8 * bar : 1.6 * bar, -0.05 * all.top, few ? 0.4 : 0.2);
}

// The picture goes into the file `path`, as its ending says.
void write_script(std::ostream& out, const std::string& path, const Plot& plot) {
  const Layout all = layout_of(plot);
  const double wide = all.width, high = all.height;
  out << fmt::format("set terminal {} size {},{} font 'DejaVu Sans,10' noenhanced\n",
                     path.ends_with(".svg") ? "svg background 'white'" : "pngcairo", all.width,
                     all.height)
      << fmt::format("set output {}\n", for_gnuplot(path));
  write_data(out, plot, all);
  // One scale of colours for all pictures: half a step and a step are what one looks for.
  out << "set multiplot\n"
      << fmt::format("set label 1 {} at screen 0.5,{:.6f} center font ',12'\n",
                     for_gnuplot(plot.title), 1 - 18 / high)
      << fmt::format(
             "set label 2 'paths over the curve; below them the distance of each point from it, "
             "in steps{}' at screen 0.5,{:.6f} center\n",
             worst_of(plot) > worst_shown ? fmt::format(", cut at {}", worst_shown) : "",
             1 - 40 / high)
      << "set palette defined (0 '#2c7bb6', 0.25 '#5ab4ac', 0.5 '#fdae61', 1 '#d7191c', 2 "
         "'#5e1065')\n"
      << fmt::format("set cbrange [0:{0}]\nset cblabel 'steps off'\nset cbtics 0.5\n", worst_shown)
      << fmt::format("set colorbox user origin screen {:.6f},{:.6f} size screen {:.6f},{:.6f}\n",
                     all.colours.x / wide, 1 - (all.colours.y + all.colours.height) / high,
                     all.colours.width / wide, all.colours.height / high)
      << "set grid xtics mxtics ytics mytics lt 1 lc rgb '#d4d4d4', lt 1 lc rgb '#e8e8e8'\n"
      << "set style fill solid 1 noborder\nunset key\nset tics nomirror\n";
  for (int i = 0; i < static_cast<int>(plot.series.size()); ++i) {
    write_path(out, plot, all, i);
    if (i == 0) out << "unset colorbox\nunset label\n";
    write_bars(out, plot, all, i);
  }
  out << "unset multiplot\n";
}

}  // namespace

namespace fs = std::filesystem;

void Series::check_steps(std::uint64_t steps) {
  if (steps < most_marks) return;
  throw InputError(
      fmt::format("--plot: a path of more than {} steps is too long to draw", most_marks - 1));
}

void Series::add(const Mark& mark) {
  check_steps(marks.size());
  finite(mark.off);
  finite(mark.along);
  marks.push_back(mark);
}

void check_plot() {
  if (run_program({"gnuplot", "--version"}).status != 0) {
    throw InputError("--plot: needs gnuplot, which is not installed (apt-get install gnuplot-nox)");
  }
}

void draw_plot(const std::string& path, const Plot& plot) {
  const Scratch scratch;
  const std::string script = scratch.path() / "plot.gp";
  const std::string picture = scratch.path() / ("picture" + fs::path(path).extension().string());
  {
    std::ofstream out(script);
    write_script(out, picture, plot);
    if (!out.flush()) throw InputError(fmt::format("--plot: {}: cannot write", script));
  }
  const auto ended = run_program({"gnuplot", script});
  if (ended.status != 0) throw InputError(fmt::format("--plot: {}: gnuplot failed", path));
  // Of a full disk gnuplot says nothing.
  const std::string text = read_file(picture);
  const std::string end = text.substr(text.size() - std::min<std::size_t>(text.size(), 12));
  if (end.find("</svg>") == std::string::npos && end.find("IEND") == std::string::npos) {
    throw InputError(fmt::format("--plot: {}: gnuplot could not write it whole", path));
  }
  write_file(path, text);  // it may be on another disk
}

}  // namespace cosim
