// What is compared: lines and arcs, and where each of them lies.
#pragma once

#include <vector>

#include "model/toolpath/plan.h"
#include "tb/studies/comparison/figures.h"

namespace cosim::compare {

/// Where a line or an arc lies in the plane, and which steps of a whole path are its.
struct Place {
  toolpath::Orientation orientation;
  plane::Point origin;  ///< of a line its start, of an arc its centre
  double begin = 0;        ///< steps of the path before it
  double steps = 0;
};

/// Pieces of one kind, and the place of each.
template <class Piece>
struct Batch {
  std::vector<Piece> works;
  std::vector<Place> places;
};

struct Work {
  Batch<Line> lines;
  Batch<Arc> arcs;
};

/// One line or arc where it stands.
Work work_of(const Line& line);
Work work_of(const Arc& arc);

/// All pieces of a plan; arcs as far as the circular machine draws them.
Work work_of(const toolpath::Plan& plan);

}  // namespace cosim::compare
