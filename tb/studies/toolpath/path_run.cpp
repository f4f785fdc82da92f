#include "tb/studies/toolpath/path_run.h"

#include <fmt/core.h>

#include <utility>

#include "tb/designs/circular/figures.h"
#include "tb/designs/linear/figures.h"
#include "tb/sim/job_check.h"

namespace cosim {
namespace {

using toolpath::Point;

// Takes machine steps to the plane and hands them on.
class Pen {
 public:
  Pen(const StepSink& sink, PathResult& result) : sink_(sink), result_(result) {}

  void begin(const toolpath::Piece& piece) { piece_ = &piece; }
  void step(Point machine) {
    const Point d = piece_->orientation.to_plane(machine);
    at_ = {at_.x + d.x, at_.y + d.y};
    ++result_.steps;
    sink_(piece_->segment, d, at_);
  }
  Point at() const { return at_; }

 private:
  const StepSink& sink_;
  PathResult& result_;
  const toolpath::Piece* piece_ = nullptr;
  Point at_;
};

template <class Design>
class PenOf final : public Observer<Design> {
 public:
  PenOf(Pen& pen, const typename Design::Params& p) : pen_(pen), p_(p) {}
  void clock(std::size_t, const Compared<Design>& seen) override {
    for_each_step(p_, seen.outputs, [this](Word dx, Word dy) { pen_.step({dx, dy}); });
  }

 private:
  Pen& pen_;
  typename Design::Params p_;
};

template <class Figures, class Design>
void draw_piece(Session<Design>& session, const typename Design::Params& p,
                const JobOf<Design>& job, Observer<Design>& pen, Result& sum) {
  JobCheck<Design, Figures> check(p, {&job, 1});
  Observers<Design> both{&check, &pen};
  Run run = session.draw({&job, 1}, both);
  add(sum, result_of(std::move(run), check.so_far()));
}

}  // namespace

double PathResult::max_deviation() const {
  Result both = lines;
  add(both, arcs);
  return both.checked.number("max_deviation");
}

PathRun::PathRun(const Bench<linear::Design>& lines, const Bench<circular::Design>& arcs,
                 CodeChooser code, std::uint32_t power_up)
    : line_params_(lines.params()),
      arc_params_(arcs.params()),
      lines_(lines.open(power_up)),
      arcs_(arcs.open(power_up)),
      code_(std::move(code)) {}

PathResult PathRun::draw(const toolpath::Plan& plan, const StepSink& sink) {
  PathResult result;
  Pen pen(sink, result);
  PenOf<linear::Design> line_pen(pen, line_params_);
  PenOf<circular::Design> arc_pen(pen, arc_params_);
  for (std::size_t s = 0; s < plan.segments.size(); ++s) {
    const toolpath::Segment& segment = plan.segments[s];
    const std::string name =
        fmt::format("segment {}, line {} of the program", s + 1, segment.place.line);
    Result* last = &result.lines;
    for (std::size_t i = 0; i < segment.pieces; ++i) {
      const toolpath::Piece& piece = plan.pieces[segment.first_piece + i];
      pen.begin(piece);
      if (const auto* line = std::get_if<toolpath::LineJob>(&piece.job)) {
        const int m = linear::sizes_of(line_params_).m;
        const linear::Job job{{line->major, code_(m, line->major, line->minor)}, {}};
        last = &result.lines;
        draw_piece<linear::LineFigures>(*lines_, line_params_, job, line_pen, *last);
      } else {
        const auto& arc = std::get<circular::Arc>(piece.job);
        last = &result.arcs;
        draw_piece<circular::ArcFigures>(*arcs_, arc_params_, arc, arc_pen, *last);
      }
      if (!last->match()) {
        last->failed = name;
        break;
      }
    }
    if (result.match() && !(pen.at() == segment.end)) {
      last->checked.error = fmt::format("ends at ({}, {}), not at ({}, {})", pen.at().x, pen.at().y,
                                        segment.end.x, segment.end.y);
      last->failed = name;
    }
    if (!result.match()) break;
  }
  result.end = pen.at();
  return result;
}

}  // namespace cosim
