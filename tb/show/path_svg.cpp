#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tb/show/svg.h"

namespace cosim {
namespace {

using Points = std::vector<std::pair<double, double>>;

constexpr double picture_side = 420;  // of the picture, in pixels
constexpr double margin = 34;

// The part of the grid that both paths are in.
struct Frame {
  double x0, x1, y0, y1, scale;

  explicit Frame(const SvgPath& path) {
    x0 = x1 = path.actual.front().first;
    y0 = y1 = path.actual.front().second;
    for (const Points* points : {&path.expected, &path.actual}) {
      for (const auto& [px, py] : *points) {
        x0 = std::min(x0, px), x1 = std::max(x1, px);
        y0 = std::min(y0, py), y1 = std::max(y1, py);
      }
    }
    scale = std::min(40.0, (picture_side - 2 * margin) / std::max({x1 - x0, y1 - y0, 1.0}));
  }
  double x(double at) const { return margin + (at - x0) * scale; }
  double y(double at) const { return margin + (y1 - at) * scale; }
  double width() const { return std::max(2 * margin + (x1 - x0) * scale, 220.0); }
  double height() const { return 2 * margin + (y1 - y0) * scale; }
};

double between(const std::pair<double, double>& a, const std::pair<double, double>& b) {
  return std::max(std::abs(a.first - b.first), std::abs(a.second - b.second));
}

// What is far more than the others of its steps: there another path begins.
double jump_of(const Points& points) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i] != points[i - 1]) steps.push_back(between(points[i], points[i - 1]));
  }
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return 4 * *middle;
}

std::string line(const Frame& frame, const Points& points) {
  const double jump = jump_of(points);
  std::string d;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool begins = i == 0 || between(points[i], points[i - 1]) > jump;
    d += fmt::format("{}{:.1f} {:.1f}", begins ? 'M' : 'L', frame.x(points[i].first),
                     frame.y(points[i].second));
  }
  return d;
}

// Without where it rests before it begins elsewhere.
SvgPath without_rest(SvgPath path) {
  const double jump = jump_of(path.actual);
  for (std::size_t i = 1; i < std::min(path.actual.size(), path.expected.size()); ++i) {
    if (path.actual[i] == path.actual[0] && path.expected[i] == path.expected[0]) continue;
    if (between(path.actual[i], path.actual[0]) <= jump) break;
    for (Points* points : {&path.actual, &path.expected}) {
      points->erase(points->begin(), points->begin() + static_cast<std::ptrdiff_t>(i));
    }
    break;
  }
  return path;
}

template <class... Values>
void put(std::string& out, fmt::format_string<Values...> format, Values&&... values) {
  out += fmt::format(format, std::forward<Values>(values)...);
}

}  // namespace

std::string path_svg(const SvgPath& given) {
  const SvgPath path = without_rest(given);
  const auto moves = [](const Points& points) {
    return std::ranges::any_of(points, [&](const auto& point) { return point != points.front(); });
  };
  if (!moves(path.actual) && !moves(path.expected)) return "";
  const Frame frame(path);
  std::string out;
  put(out,
      "<svg class=\"path\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\">",
      frame.width(), frame.height());
  // Where single steps can be told apart, the grid and its points.
  const bool shows_steps = frame.scale >= 6;
  if (shows_steps) {
    put(out, "<path class=\"grid\" d=\"");
    for (double at = frame.x0; at <= frame.x1; ++at) {
      put(out, "M{:.1f} {:.1f}V{:.1f}", frame.x(at), frame.y(frame.y0), frame.y(frame.y1));
    }
    for (double at = frame.y0; at <= frame.y1; ++at) {
      put(out, "M{:.1f} {:.1f}H{:.1f}", frame.x(frame.x0), frame.y(at), frame.x(frame.x1));
    }
    put(out, "\"/>");
  }
  if (path.expected != path.actual) {
    put(out, "<path class=\"over\" fill=\"none\" d=\"{}\"/>", line(frame, path.expected));
  }
  put(out, "<path class=\"l a\" d=\"{}\"/>", line(frame, path.actual));
  if (shows_steps) {
    for (const auto& [px, py] : std::set(path.actual.begin(), path.actual.end())) {
      put(out, "<circle class=\"dot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>", frame.x(px),
          frame.y(py));
    }
  }
  const auto mark = [&](const std::pair<double, double>& at, const char* what) {
    put(out,
        "<text class=\"n\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{} ({:g}, {:g})</text>",
        frame.x(at.first),
        frame.y(at.second) + (frame.y(at.second) < frame.height() / 2 ? -12 : 22),
        frame.x(at.first) < frame.width() / 3       ? "start"
        : frame.x(at.first) > frame.width() * 2 / 3 ? "end"
                                                    : "middle",
        what, at.first, at.second);
  };
  mark(path.actual.front(), "from");
  mark(path.actual.back(), "to");
  const std::size_t both = std::min(path.expected.size(), path.actual.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (path.expected[i] == path.actual[i]) continue;
    const auto& apart = path.expected[i == 0 ? 0 : i - 1];
    put(out, "<circle class=\"ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\"/>", frame.x(apart.first),
        frame.y(apart.second));
    break;
  }
  return out + "</svg>\n";
}

}  // namespace cosim
