#include "tb/studies/comparison/cli/drawn.h"

#include <algorithm>

namespace cosim {
namespace {

using compare::Place;
using prior_art::Point;

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

}  // namespace

void add_points(Series& series, const compare::Line& line, const Place& place,
                const compare::Points& points) {
  add(series, line, place, points);
}

void add_points(Series& series, const compare::Arc& arc, const Place& place,
                const compare::Points& points) {
  add(series, arc, place, points);
}

}  // namespace cosim
