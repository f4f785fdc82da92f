#include "tb/studies/toolpath/pieces.h"

#include "model/toolpath/arc_pieces.h"

namespace cosim::pieces {
namespace {

using plane::Point;
using toolpath::Piece;

// The arc of a piece, to where the circular machine is stopped.
Arc arc_of(const circular::Arc& job) {
  if (!job.count) return {job.from, job.radius2, circular::end_point(job.radius2)};
  return {job.from, job.radius2, toolpath::point_after(job.from, job.radius2, *job.count)};
}

// Adds a piece that starts at `from` in the plane; returns where it ends.
class Adder {
 public:
  explicit Adder(Work& work) : work_(work) {}

  void add(const Piece& piece) {
    const auto count = static_cast<double>(steps(piece));
    Point way;
    if (const auto* line = std::get_if<toolpath::LineJob>(&piece.job)) {
      add(work_.lines, Line{line->major, line->minor}, {piece.orientation, at_, begin_, count});
      way = {line->major, line->minor};
    } else {
      const Arc arc = arc_of(std::get<circular::Arc>(piece.job));
      const Point from = piece.orientation.to_plane(arc.from);
      const Point centre{at_.x - from.x, at_.y - from.y};
      add(work_.arcs, arc, {piece.orientation, centre, begin_, count});
      way = {arc.to.x - arc.from.x, arc.to.y - arc.from.y};
    }
    way = piece.orientation.to_plane(way);
    at_ = {at_.x + way.x, at_.y + way.y};
    begin_ += count;
  }

 private:
  template <class W>
  static void add(Batch<W>& batch, const W& work, const Place& place) {
    batch.works.push_back(work);
    batch.places.push_back(place);
  }

  Work& work_;
  Point at_;
  double begin_ = 0;
};

}  // namespace

Work work_of(const Line& line) {
  return {{{line}, {{{}, {}, 0, static_cast<double>(line.major)}}}, {}};
}

Work work_of(const Arc& arc) {
  const auto steps = static_cast<double>(circular::steps_to(arc.from, arc.radius2, arc.to));
  return {{}, {{arc}, {{{}, {}, 0, steps}}}};
}

Work work_of(const toolpath::Plan& plan) {
  Work work;
  Adder adder(work);
  for (const Piece& piece : plan.pieces) adder.add(piece);
  return work;
}

}  // namespace cosim::pieces
