// From the words of an arc to its centre and sweep.
#pragma once

#include <cstdint>
#include <string>

namespace cosim::toolpath {

constexpr double pm_per_mm = 1e9;

/// A position in picometres (1e-9 mm); each coordinate at most 1e18.
struct Position {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const Position&, const Position&) = default;
};

struct ArcGeometry {
  Position centre;    ///< each coordinate below 4e18
  double sweep = 0;   ///< radians, 0 < sweep <= 2 pi
  std::string wrong;  ///< empty, or why there is no such arc; the rest is then void
};

/// How far an arc's end may be off its circle: `floor` (in mm), or a thousandth of the radius up to
/// 0.5 mm where that is more.
double arc_tolerance(double radius_mm, double floor_mm);

/// The arc about start + offset (words I and J); a full circle where `end` is `start`. An end on
/// the ray from the centre through the start counts as a whole turn.
ArcGeometry arc_about(Position start, Position end, Position offset, bool clockwise,
                      double floor_mm);

/// The arc of radius |radius| (word R, picometres, at most 1e18): at most half a turn for a
/// positive one, at least half for a negative one.
ArcGeometry arc_of_radius(Position start, Position end, std::int64_t radius, bool clockwise,
                          double floor_mm);

}  // namespace cosim::toolpath
