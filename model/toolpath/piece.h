// A piece of work for one of the two machines, and how its steps lie in the plane.
#pragma once

#include <cstdint>
#include <variant>

#include "model/circular/arc.h"
#include "model/plane/point.h"

namespace cosim::toolpath {

using plane::Point;

/// Takes a machine's two outputs to the plane's axes: a machine step (u, v) is the step
/// (xu * u + xv * v, yu * u + yv * v) of the path. A rotation by quarter turns or a reflection:
/// each row and each column holds one 1 or -1 and one 0.
/// For the linear machine u is the major axis and v the minor; for the circular one u is x and v y.
struct Orientation {
  std::int8_t xu = 1;
  std::int8_t xv = 0;
  std::int8_t yu = 0;
  std::int8_t yv = 1;

  Point to_plane(Point p) const { return {xu * p.x + xv * p.y, yu * p.x + yv * p.y}; }
  Point to_machine(Point p) const { return {xu * p.x + yu * p.y, xv * p.x + yv * p.y}; }
  friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// A line for the linear machine: 0 <= minor <= major, 1 <= major < 2^32. The control code is the
/// caller's choice, as it hangs on the machine's width m with major < 2^m.
struct LineJob {
  std::int64_t major = 0;
  std::int64_t minor = 0;
};

struct Piece {
  std::uint32_t segment = 0;  ///< from 1
  Orientation orientation;
  /// The arc in the machine's own quadrant, round(R) < 2^32. Without a count it runs to (0, R);
  /// with one it is ended after 1 <= count < steps_to_end steps.
  std::variant<LineJob, circular::Arc> job;
};

/// The elementary steps of the piece, at least 1.
std::int64_t steps(const Piece& piece);

/// The line from `from` to `to` by octant; |to - from| < 2^32 on each axis, and not (0, 0).
Piece line_piece(std::uint32_t segment, Point from, Point to);

}  // namespace cosim::toolpath
