// A program as work for the two machines, and what quantising it to the grid has cost.
#pragma once

#include <cstdint>
#include <vector>

#include "model/toolpath/gcode.h"
#include "model/toolpath/piece.h"
#include "model/toolpath/quantise.h"

namespace cosim::toolpath {

/// One motion of the program on the grid. Lengths are in steps.
struct Segment {
  MotionKind kind = MotionKind::rapid;
  Place place;
  Point start;                ///< the end of the segment before, exactly; (0, 0) for the first
  Point end;                  ///< the quantised target
  Point centre;               ///< of an arc: the grid point nearest to the exact centre
  std::uint64_t radius2 = 0;  ///< of the circle drawn; 0 for lines and arcs drawn as a mere line
  std::size_t first_piece = 0;
  std::size_t pieces = 0;    ///< may be 0: a motion of less than a step moves no axis
  std::int64_t closing = 0;  ///< of an arc: the major length of the line that closes it
  /// How far the quantised curve is from the exact one. Of a line: the larger distance of its ends
  /// from the exact ends (no point of it is further). Of an arc: that of the ends or, where it is
  /// more, of the circles - the distance of the centres plus the difference of the radii, the
  /// larger one where the exact ends have two radii. Of an arc drawn as a mere line: a bound. The
  /// closing line is apart from this, in `closing`. 0 where it is no more than doubles round.
  double quantisation = 0;
};

struct Plan {
  std::vector<Segment> segments;  ///< segment i + 1 is motion i of the program
  std::vector<Piece> pieces;      ///< in the order they are to run
  std::int64_t longest_line = 0;  ///< the largest major length of a line
  int arc_width = 0;              ///< the circular machine's least width; 0 where there is no arc
  std::int64_t largest_closing = 0;
  double largest_quantisation = 0;
};

/// The plan of a program. A target is quantised by itself (quantise.h), a line goes to the linear
/// machine by its octant, an arc to the circular one by quadrants (arc_pieces.h) and then, where
/// its quantised end is off the circle drawn, a step or two to the linear one: after each segment
/// the path stands exactly on the quantised target.
/// InputError for steps_per_mm not finite or not above 0, and, with the motion's place, for a
/// target beyond max_coordinate and a radius beyond max_radius.
Plan plan(const Program& program, double steps_per_mm);

}  // namespace cosim::toolpath
