// How GoogleTest prints a point.
#pragma once

#include <ostream>

#include "model/plane/point.h"

namespace cosim::plane {

inline void PrintTo(const Point& p, std::ostream* out) { *out << p.x << ',' << p.y; }

}  // namespace cosim::plane
