// From millimetres to whole steps of the grid.
#pragma once

#include <cstdint>
#include <optional>

#include "model/plane/point.h"
#include "model/toolpath/gcode.h"

namespace cosim::toolpath {

/// A grid point in machine coordinates, in steps.
using plane::Point;

/// The reach of the machines: |x| and |y| of a position, and the radius of an arc, in steps.
inline constexpr std::int64_t max_coordinate = (std::int64_t{1} << 31) - 1;
inline constexpr std::int64_t max_radius = (std::int64_t{1} << 32) - 1;

/// The most steps in a millimetre.
inline constexpr double finest_grid = 1e9;

/// The grid point nearest to `p`, halves, as written in decimals, away from 0; none where a
/// coordinate would be more than `reach` <= 2^52 steps. Each point is quantised by itself, never
/// from the one before, so the error of a target never exceeds half a step an axis. steps_per_mm is
/// > 0 and at most finest_grid.
std::optional<Point> quantise(PointMm p, double steps_per_mm, std::int64_t reach);

/// The distance in steps between `p` and the grid point `q`.
double distance(PointMm p, double steps_per_mm, Point q);

}  // namespace cosim::toolpath
