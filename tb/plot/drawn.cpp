#include "tb/plot/drawn.h"

#include <algorithm>
#include <cmath>

#include "model/dda/equation.h"

namespace cosim {
namespace {

using compare::Place;
using prior_art::Point;

std::pair<double, double> in_plane(const Place& place, double x, double y) {
  const toolpath::Orientation& o = place.orientation;
  return {static_cast<double>(place.origin.x) + o.xu * x + o.xv * y,
          static_cast<double>(place.origin.y) + o.yu * x + o.yv * y};
}

template <class Work>
void add(Series& series, const Work& work, const Place& place, compare::Points points) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const double last = std::max(1.0, static_cast<double>(points.size()) - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point d = place.orientation.to_plane(points[i]);
    series.add({{place.origin.x + d.x, place.origin.y + d.y},
                compare::radial(work, points[i]),
                place.begin + place.steps * static_cast<double>(i) / last});
  }
}

template <class Batch>
void add_curves(std::vector<Curve>& all, const Batch& batch) {
  for (std::size_t i = 0; i < batch.works.size(); ++i) {
    all.push_back(curve_of(batch.works[i], batch.places[i]));
  }
}

}  // namespace

Curve curve_of(const compare::Line& line, const Place& place) {
  return {in_plane(place, 0, 0),
          in_plane(place, static_cast<double>(line.major), static_cast<double>(line.minor))};
}

Curve curve_of(const compare::Arc& arc, const Place& place) {
  constexpr int parts = 64;
  const auto angle = [](Point p) {
    return std::atan2(static_cast<double>(p.y), static_cast<double>(p.x));
  };
  const double radius = std::sqrt(static_cast<double>(arc.radius2));
  Curve curve;
  for (int i = 0; i <= parts; ++i) {
    const double at = angle(arc.from) + (angle(arc.to) - angle(arc.from)) * i / parts;
    curve.push_back(in_plane(place, radius * std::cos(at), radius * std::sin(at)));
  }
  return curve;
}

std::vector<Curve> curves_of(const compare::Work& work) {
  std::vector<Curve> all;
  add_curves(all, work.lines);
  add_curves(all, work.arcs);
  return all;
}

Curve curve_of(const dda::Job& job, const std::vector<Mark>& marks) {
  Curve curve;
  for (const Mark& mark : marks) curve.push_back(on_curve(job, mark.at));
  return curve;
}

void add_points(Series& series, const compare::Line& line, const Place& place,
                const compare::Points& points) {
  add(series, line, place, points);
}

void add_points(Series& series, const compare::Arc& arc, const Place& place,
                const compare::Points& points) {
  add(series, arc, place, points);
}

}  // namespace cosim
