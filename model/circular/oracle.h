// The exact definition of the circular machine's points, with no state of a machine: each is the
// one of the two points in reach that is nearest to the circle along the axis that rests.
#pragma once

#include <cstdint>

#include "model/circular/arc.h"

namespace cosim::circular {

/// The point after `p` on the way to (0, R): where x > y, on row y + 1, the one of x and x - 1
/// nearest to the circle; where y >= x, in column x - 1, the one of y and y + 1. From a point next
/// to the circle every point is next to it again (next_to_circle). Where the arc is over (y >= x,
/// x < 1) there is no next point and `p` itself is returned.
///
/// The choice is of two for the sake of the step across the diagonal: there the nearest x of the
/// row can fall by 2 (radius 23: x = 16.52 on row 16, 15.49 on row 17). The machine falls by 1 and
/// then is on the nearest point of its new column instead.
Point next_point(Point p, std::uint64_t radius2);

/// |sqrt(x^2 + y^2) - sqrt(radius2)| in steps, accurate to 1e-9 of a step for points near the
/// circle and to the precision of a double elsewhere.
double radial_deviation(Point p, std::uint64_t radius2);
/// The same of a point whose x^2 + y^2 is so much more than radius2; at least -radius2.
double radial_deviation_by(std::int64_t excess, std::uint64_t radius2);
/// That, within a millionth of it, at once; or no number.
double about_radial_deviation_by(std::int64_t excess, std::uint64_t radius2);

}  // namespace cosim::circular
