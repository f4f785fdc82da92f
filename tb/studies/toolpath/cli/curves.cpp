#include "tb/studies/toolpath/cli/curves.h"

#include "tb/designs/circular/cli/curve.h"

namespace cosim {
namespace {

Curve shape_of(const pieces::Line& line) {
  return {{0, 0}, {static_cast<double>(line.major), static_cast<double>(line.minor)}};
}

Curve shape_of(const pieces::Arc& arc) { return circular::curve_of(arc.from, arc.radius2, arc.to); }

template <class Batch>
void add_curves(std::vector<Curve>& all, const Batch& batch) {
  for (std::size_t i = 0; i < batch.works.size(); ++i) {
    const pieces::Place& place = batch.places[i];
    const toolpath::Orientation& o = place.orientation;
    all.push_back(shape_of(batch.works[i]));
    for (auto& [x, y] : all.back()) {
      const double u = x, v = y;
      x = static_cast<double>(place.origin.x) + o.xu * u + o.xv * v;
      y = static_cast<double>(place.origin.y) + o.yu * u + o.yv * v;
    }
  }
}

}  // namespace

std::vector<Curve> curves_of(const pieces::Work& work) {
  std::vector<Curve> all;
  add_curves(all, work.lines);
  add_curves(all, work.arcs);
  return all;
}

}  // namespace cosim
