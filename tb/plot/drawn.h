// Compared work in a picture: its curves, and the points that an algorithm gave.
#pragma once

#include "model/dda/host.h"
#include "tb/plot/plot.h"
#include "tb/studies/comparison/work.h"

namespace cosim {

/// The line from (0, 0) or the arc about (0, 0), and those of the work, each a curve.
Curve curve_of(const compare::Line& line, const compare::Place& place = {});
Curve curve_of(const compare::Arc& arc, const compare::Place& place = {});
std::vector<Curve> curves_of(const compare::Work& work);
/// The DDA's curve beside a path: the point of it that is next to each mark.
Curve curve_of(const dda::Job& job, const std::vector<Mark>& marks);

/// Adds the points that were drawn of a piece, each once: spread evenly over the piece's part of
/// the path, so that algorithms of more and of fewer steps stand at the same places.
void add_points(Series& series, const compare::Line& line, const compare::Place& place,
                const compare::Points& points);
void add_points(Series& series, const compare::Arc& arc, const compare::Place& place,
                const compare::Points& points);

}  // namespace cosim
