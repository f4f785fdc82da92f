#include "model/toolpath/piece.h"

#include <cstdlib>

namespace cosim::toolpath {

std::int64_t steps(const Piece& piece) {
  if (const auto* line = std::get_if<LineJob>(&piece.job)) return line->major;
  const auto& arc = std::get<circular::Arc>(piece.job);
  return arc.count ? *arc.count : circular::steps_to_end(arc.from, arc.radius2);
}

Piece line_piece(std::uint32_t segment, Point from, Point to) {
  const std::int64_t dx = to.x - from.x;
  const std::int64_t dy = to.y - from.y;
  const std::int8_t sx = dx < 0 ? -1 : 1;
  const std::int8_t sy = dy < 0 ? -1 : 1;
  if (std::abs(dx) >= std::abs(dy)) {
    return {segment, {sx, 0, 0, sy}, LineJob{std::abs(dx), std::abs(dy)}};
  }
  return {segment, {0, sx, sy, 0}, LineJob{std::abs(dy), std::abs(dx)}};
}

}  // namespace cosim::toolpath
