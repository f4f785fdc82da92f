// An arc of any sweep and sense as work for the circular machine, quadrant by quadrant.
#pragma once

#include <cstdint>
#include <vector>

#include "model/toolpath/piece.h"

namespace cosim::toolpath {

/// An arc on the grid, in machine coordinates.
struct GridArc {
  Point start;
  Point end;     ///< need not lie on the circle
  Point centre;  ///< within max_radius of start and end
  bool clockwise = false;
  double sweep = 0;  ///< of the exact arc: radians, 0 < sweep <= 2 pi
};

struct ArcPieces {
  std::vector<Piece> pieces;  ///< may be empty
  std::uint64_t radius2 = 0;  ///< of the circle drawn; 0 where none is
  Point reached;              ///< where the pieces end: `end`, or a few steps from it
};

/// The rule for arcs whose quantised ends do not lie on one circle about a grid point:
///  1. The circle is the one about `centre` whose squared radius is the mean of those of start and
///     end, rounded, or the nearest to it for which start is next to the circle, so that the arc
///     begins at start without an extra step. (An arc back to its start: that of start.)
///  2. The sweep is the turn from start to end as quantised, plus or minus whole turns: the one
///     nearest to the exact sweep. If it is not positive - a short arc fallen onto one point or
///     turned about by rounding -, or if start or end is the centre, no arc is drawn.
///  3. Every full quadrant is drawn to its axis; in the last one the machine is stopped level with
///     end: on its row where end lies in the sector next to the start of the quadrant (x > y in the
///     machine's frame), in its column otherwise.
///  4. What is left to end is the caller's to close by a straight line.
/// Of two million random arcs whose exact ends lie on the exact circle, 80 % ended on the spot,
/// 20 % were left one step to close, 0.1 % two and one of them three; their points were at most
/// 2.3 steps from the exact circle, 1.9 of it quantisation and 0.5 the machine. What a program's
/// own end is off its circle (gcode.h) comes on top.
/// The circular machine draws one quadrant anticlockwise; the others are its turns, and clockwise
/// arcs its mirror images.
ArcPieces arc_pieces(std::uint32_t segment, const GridArc& arc);

/// Where the circular machine stands `steps` steps after `from`, without walking there.
/// `from` is next to the circle, 0 <= steps <= steps_to_end.
Point point_after(Point from, std::uint64_t radius2, std::int64_t steps);

}  // namespace cosim::toolpath
