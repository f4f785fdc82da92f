// A part of a circle in a picture.
#pragma once

#include "model/circular/arc.h"
#include "tb/plot/plot.h"

namespace cosim::circular {

/// The circle of R^2 = `radius2` about (0, 0), from the angle of `from` to that of `to`.
Curve curve_of(Point from, std::uint64_t radius2, Point to);

}  // namespace cosim::circular
