// A conic's equation, exactly: its numbers are those of a person, and their products large.
#pragma once

#include <cstdint>
#include <optional>

#include "model/plane/point.h"

namespace cosim::dda {

using plane::Point;

/// The largest A to E in size, and the largest F.
inline constexpr std::int64_t largest_factor = 0x7fffffff;
inline constexpr std::int64_t largest_constant = std::int64_t{1} << 57;

/// A x^2 + B xy + C y^2 + D x + E y + F = 0.
struct Conic {
  std::int64_t a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;
};

/// InputError "conic: ..." where a coefficient is too large or the conic lines, a point or nothing.
void check(const Conic& conic);

/// x' and y' at a point of a checked conic, each coordinate at most 2^32 in size. InputError where
/// the point is its centre or more than half a step off the curve (its equation over its gradient),
/// or a rate is 2^62 or more in size.
Point rates_at(const Conic& conic, Point at);

/// The root of 4 A C - B^2 of a checked ellipse; none of another curve.
std::optional<double> ellipse_root(const Conic& conic);

}  // namespace cosim::dda
