// Placed lines and arcs in a picture.
#pragma once

#include "tb/show/plot.h"
#include "tb/studies/toolpath/pieces.h"

namespace cosim {

/// Each line and each arc of the work, where it lies, as a curve.
std::vector<Curve> curves_of(const pieces::Work& work);

}  // namespace cosim
