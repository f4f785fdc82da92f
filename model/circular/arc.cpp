#include "model/circular/arc.h"
#include "model/core/wide.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cosim::circular {
namespace {

// floor(sqrt(q)). The square root of a double is off by less than one at 2^32: the loops mend it.
std::uint64_t floor_root(std::uint64_t q) {
  constexpr std::uint64_t kLargest = 0xffff'ffff;
  auto root = std::min(static_cast<std::uint64_t>(std::sqrt(static_cast<double>(q))), kLargest);
  while (root * root > q) --root;
  while (root < kLargest && (root + 1) * (root + 1) <= q) ++root;
  return root;
}

bool in_sector1(Point p) { return p.x > p.y; }

Point bounded(Point p) {
  constexpr std::int64_t kLargest = std::int64_t{1} << 32;
  return {std::clamp<std::int64_t>(p.x, 0, kLargest), std::clamp<std::int64_t>(p.y, 0, kLargest)};
}

// The first point with x <= y of an arc that comes from row `row` of sector 1. With x nearest to
// the circle on row y, x <= y means radius2 - y^2 < (y + 1/2)^2, that is radius2 <= 2y^2 + y: the
// first such row is y = floor(sqrt(radius2 / 2)) or the one above. The row below had x >= y,
// and a step takes at most one from x.
Point sector_change(std::int64_t row, std::uint64_t radius2) {
  const std::uint64_t y = floor_root(radius2 / 2);
  const std::uint64_t first = y < radius2 - 2 * y * y ? y + 1 : y;
  const auto reached = std::max(static_cast<std::int64_t>(first), row + 1);
  return {std::clamp(nearest_on(reached, radius2), reached - 1, reached), reached};
}

}  // namespace

std::int64_t nearest_root(std::uint64_t q) {
  const std::uint64_t root = floor_root(q);
  return static_cast<std::int64_t>(q - root * root > root ? root + 1 : root);
}

std::int64_t nearest_on(std::int64_t line, std::uint64_t radius2) {
  const Int128 rest = radius2 - Int128{line} * line;  // at most 2^126 less
  return rest > 0 ? nearest_root(static_cast<std::uint64_t>(rest)) : 0;
}

bool next_to_circle(Point p, std::uint64_t radius2) {
  if (p.x < 0 || p.y < 0) return false;
  return in_sector1(p) ? p.x == nearest_on(p.y, radius2) : p.y == nearest_on(p.x, radius2);
}

// Unsigned words wrap at 2^64, as the contract says. F is 1/4 less than an integer: its floor is
// one less than that integer.
Setup setup(Point from, std::uint64_t radius2) {
  const auto signed_word = [](std::uint64_t v) { return static_cast<std::int64_t>(v); };
  const auto x = static_cast<std::uint64_t>(from.x);
  const auto y = static_cast<std::uint64_t>(from.y);
  if (in_sector1(from)) {  // F = radius2 - (x - 1/2)^2 - (y + 1)^2
    const std::uint64_t f = radius2 - x * x + x - (y + 1) * (y + 1) - 1;
    return {signed_word(f), from.y, signed_word(x - y - 1), false};
  }
  // F = radius2 - (x - 1)^2 - (y + 1/2)^2
  const std::uint64_t f = radius2 - (x - 1) * (x - 1) - y * y - y - 1;
  return {signed_word(f), signed_word(x - 1), signed_word(x - y), true};
}

Point end_point(std::uint64_t radius2) { return {0, nearest_root(radius2)}; }

std::int64_t steps_to(Point from, std::uint64_t radius2, Point target) {
  const Point start = bounded(from);
  const Point goal = bounded(target);
  if (!in_sector1(start)) return in_sector1(goal) ? 0 : std::max<std::int64_t>(start.x - goal.x, 0);
  const Point change = sector_change(start.y, radius2);
  if (in_sector1(goal)) return std::max<std::int64_t>(std::min(goal.y, change.y) - start.y, 0);
  return change.y - start.y + std::max<std::int64_t>(change.x - goal.x, 0);
}

std::int64_t steps_to_end(Point from, std::uint64_t radius2) {
  return steps_to(from, radius2, end_point(radius2));
}

int width_needed(std::uint64_t radius2) {
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(nearest_root(radius2))));
}

}  // namespace cosim::circular
