// A G-code program as the XY motions it asks for, exact and in millimetres.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/toolpath/source.h"

namespace cosim::toolpath {

struct PointMm {
  double x = 0;
  double y = 0;
  friend bool operator==(const PointMm&, const PointMm&) = default;
};

enum class MotionKind : std::uint8_t { rapid, feed, arc_cw, arc_ccw };

inline bool is_arc(MotionKind kind) { return kind >= MotionKind::arc_cw; }

/// One block that moves X or Y. Coordinates are the program's, each the double nearest to a whole
/// number of picometres (1e-9 mm), and at most 1e9 mm; they start at (0, 0).
struct Motion {
  MotionKind kind = MotionKind::rapid;
  PointMm start;  ///< the end of the motion before
  PointMm end;
  PointMm centre;            ///< of an arc
  double sweep = 0;          ///< of an arc: the angle turned, in radians, 0 < sweep <= 2 pi
  bool full_circle = false;  ///< an arc whose end is its start
  Place place;               ///< of the block's first word out of X Y I J R
};

struct Program {
  std::string name;                    ///< stands in later errors, as the file's name
  std::vector<Motion> motions;         ///< in order; motion i is segment i + 1
  std::uint64_t lines = 0;             ///< lines read, up to the end of the program
  std::uint64_t lines_unread = 0;      ///< behind it; blank lines, comments and `%` do not count
  std::uint64_t blocks = 0;            ///< lines with a word
  std::uint64_t other_axis_moves = 0;  ///< blocks that move Z, A, B, C, U, V or W: not drawn
};

/// The most motions a program may have.
inline constexpr std::size_t max_motions = 1'000'000;

/// Reads a program; what a line may hold stands in lexer.h, the codes in codes.h. The rules:
///  - At the start X, Y and all other axes are 0, G17 G21 G90 hold and no motion mode: axis words
///    before any of G0 G1 G2 G3 are an error. G80 and the codes that end scaling, rotation, polar
///    coordinates and the like change nothing, for none of these is taken.
///  - A block whose X and Y words repeat the present position moves nothing: it is no motion. The
///    exception is an arc with I or J, which is then a full circle. Positions are kept in whole
///    picometres, so that this is exact and increments (G91) add up without error.
///  - G20 and G21 hold from the block they stand in; an inch is 25.4 mm.
///  - Arcs: I and J from the start to the centre, an absent one being 0; or R, where R > 0 takes
///    the arc of at most half a turn and R < 0 the other one. Both ways at once, neither way, R
///    with the end at the start, and radius 0 are errors, and so are I, J and R elsewhere. K0, an
///    offset along Z, and P1, one turn, say nothing; other values are errors.
///  - The end may be off the circle about the centre by the tolerance: 0.005 mm (0.0005 inch under
///    G20) or, where it is more, a thousandth of the radius up to 0.5 mm. The same holds for a
///    chord longer than 2 |R|, which is then taken as the diameter. Beyond it is an error.
///  - A Z word in an arc (a helix) and other axes in any motion are counted, not drawn. Axis
///    words beside G4 are an error: controls disagree on whether it is a move or a time. X or U is
///    a time where no motion mode holds.
///  - G28 and G30 with axis words that are not X or Y, and G53 without X and Y, move the other axes
///    to the machine's places; with X or Y, and G28 without axis words, they are errors. G91 beside
///    G28 holds on, G53 ends with its block.
///  - G92 and G10 L20 may give X and Y the values that they have, G52 may give them 0, and all
///    three, as G10 L2, may give other axes any value: that leaves the path alone. All else of
///    these, which may not, is an error. G92.1 and G92.2 end nothing, for no offset of X or Y is
///    ever set.
///  - M2, M30 and the closing `%` end the program; what follows is counted, not read.
/// InputError "name:line:column: what" for all else that codes.h, block.h and conditions.h do not
/// take, a program without a motion, one with more than max_motions, a coordinate beyond 1e9 mm.
/// Linear in the length of the text.
Program read_gcode(std::string_view text, const std::string& name);

}  // namespace cosim::toolpath
