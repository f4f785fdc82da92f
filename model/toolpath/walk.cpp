#include "model/toolpath/walk.h"

#include "model/circular/oracle.h"
#include "model/linear/oracle.h"

namespace cosim::toolpath {

Point walk(const Plan& plan, int m, const CodeChooser& choose,
           const std::function<void(const Step&)>& sink) {
  Point at;
  for (const Piece& piece : plan.pieces) {
    const auto take = [&](Point machine_step) {
      const Point d = piece.orientation.to_plane(machine_step);
      at = {at.x + d.x, at.y + d.y};
      sink({piece.segment, static_cast<int>(d.x), static_cast<int>(d.y), at});
    };
    const std::int64_t count = steps(piece);
    if (const auto* line = std::get_if<LineJob>(&piece.job)) {
      const linear::Code code = choose(m, line->major, line->minor);
      for (std::int64_t q = 1; q <= count; ++q) {
        take({1, linear::minor_steps_at(m, code, q) ? 1 : 0});
      }
    } else {
      const auto& arc = std::get<circular::Arc>(piece.job);
      Point p = arc.from;
      for (std::int64_t i = 0; i < count; ++i) {
        const Point next = circular::next_point(p, arc.radius2);
        take({next.x - p.x, next.y - p.y});
        p = next;
      }
    }
  }
  return at;
}

}  // namespace cosim::toolpath
