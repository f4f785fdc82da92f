// The points that an algorithm gave, in a picture.
#pragma once

#include "tb/plot/plot.h"
#include "tb/studies/comparison/work.h"

namespace cosim {

/// Adds the points that were drawn of a piece, each once: spread evenly over the piece's part of
/// the path, so that algorithms of more and of fewer steps stand at the same places.
void add_points(Series& series, const compare::Line& line, const compare::Place& place,
                const compare::Points& points);
void add_points(Series& series, const compare::Arc& arc, const compare::Place& place,
                const compare::Points& points);

}  // namespace cosim
