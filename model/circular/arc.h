// What SU 1665343 leaves to the device outside: where an arc starts, what to load for it, how many
// steps it takes. All in steps of the grid, first quadrant, anticlockwise, centre at (0, 0).
#pragma once

#include <cstdint>
#include <optional>

#include "model/plane/point.h"

namespace cosim::circular {

using plane::Point;

/// One piece of work for the machine: from `from` along x^2 + y^2 = radius2 to (0, R), or until
/// `count` steps have been made, when it is ended through input 32.
/// 0 <= x, y < 2^32; radius2 >= 1; `from` next to the circle.
struct Arc {
  Point from;
  std::uint64_t radius2 = 0;
  std::optional<std::int64_t> count;  ///< >= 0; a count past the end of the arc stops nothing
};

/// The words for inputs 29, 30 and 31 and the level of input 34, as mathematical numbers.
struct Setup {
  std::int64_t f = 0;    ///< floor(F); the machine itself appends the fraction .75
  std::int64_t ct7 = 0;  ///< Y in sector 1, X - 1 in sector 2
  std::int64_t ct8 = 0;  ///< X - Y - 1 in sector 1, X - Y in sector 2
  bool sector2 = false;  ///< start in sector 2 (Y >= X): input 34
};

/// True where `p` is the lattice point nearest to the circle along the axis that rests in its
/// sector: x along the row y where x > y, y along the column x where y >= x.
bool next_to_circle(Point p, std::uint64_t radius2);

/// The formulas of the source for F, CT7 and CT8 at a start point. Total: far from the circle,
/// where a word may not fit 64 bits, it is taken modulo 2^64.
Setup setup(Point from, std::uint64_t radius2);

/// round(sqrt(q)), exact for all of uint64; never a tie, since (n + 1/2)^2 is not an integer.
std::int64_t nearest_root(std::uint64_t q);

/// The lattice coordinate nearest to the circle on row (or column) `line`: round(sqrt(radius2 -
/// line^2)), and 0 where the row passes outside the circle.
std::int64_t nearest_on(std::int64_t line, std::uint64_t radius2);

/// The last point of the quadrant's arc: (0, round(R)).
Point end_point(std::uint64_t radius2);

/// The steps the machine makes from `from` until it is level with `target`: on its row if
/// the target lies in sector 1 (x > y), in its column if it lies in sector 2. A target next to
/// the circle is then reached exactly; one before `from` takes 0 steps; one that is level with no
/// point of its own sector counts as the change of sector. Never more than steps_to_end().
/// Closed form, no walking along the arc. `from` is next to the circle; coordinates outside 0 ..
/// 2^32 count as the nearer bound.
std::int64_t steps_to(Point from, std::uint64_t radius2, Point target);

/// The steps from `from` to end_point(). Closed form, as steps_to().
std::int64_t steps_to_end(Point from, std::uint64_t radius2);

/// The smallest width of the machine that holds the arc: round(R) < 2^width.
int width_needed(std::uint64_t radius2);

}  // namespace cosim::circular
