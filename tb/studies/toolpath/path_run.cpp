#include "tb/studies/toolpath/path_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "tb/designs/circular/check.h"
#include "tb/designs/linear/check.h"

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

class LinePen final : public Observer<linear::Design> {
 public:
  LinePen(Pen& pen, int word) : pen_(pen), word_(word) {}
  void clock(std::size_t, const Compared<linear::Design>& seen) override {
    if (!seen.outputs.strobe) return;
    for (int i = word_ - 1; i >= 0; --i) {
      if (bit(seen.outputs.major, i)) pen_.step({1, bit(seen.outputs.minor, i)});
    }
  }

 private:
  Pen& pen_;
  int word_;
};

class ArcPen final : public Observer<circular::Design> {
 public:
  explicit ArcPen(Pen& pen) : pen_(pen) {}
  void clock(std::size_t, const Compared<circular::Design>& seen) override {
    const circular::Outputs<Word>& out = seen.outputs;
    if (out.step_x | out.step_y) pen_.step({-out.step_x, out.step_y});
  }

 private:
  Pen& pen_;
};

template <class Check, class Design, class Job>
void draw_piece(Session<Design>& session, const Job& job, Check check, Observer<Design>& pen,
                Result& sum) {
  Observers<Design> both{&check, &pen};
  Run run = session.draw({&job, 1}, both);
  add(sum, result_of(std::move(run), check));
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
      lines_(lines.open(power_up)),
      arcs_(arcs.open(power_up)),
      code_(std::move(code)) {}

PathResult PathRun::draw(const toolpath::Plan& plan, const StepSink& sink) {
  PathResult result;
  Pen pen(sink, result);
  LinePen line_pen(pen, line_params_.word());
  ArcPen arc_pen(pen);
  for (std::size_t s = 0; s < plan.segments.size(); ++s) {
    const toolpath::Segment& segment = plan.segments[s];
    const std::string name =
        fmt::format("segment {}, line {} of the program", s + 1, segment.place.line);
    Result* last = &result.lines;
    for (std::size_t i = 0; i < segment.pieces; ++i) {
      const toolpath::Piece& piece = plan.pieces[segment.first_piece + i];
      pen.begin(piece);
      if (const auto* line = std::get_if<toolpath::LineJob>(&piece.job)) {
        const linear::Job job{{line->major, code_(line_params_.m, line->major, line->minor)}, {}};
        last = &result.lines;
        draw_piece(*lines_, job, linear::Check(line_params_, {&job, 1}), line_pen, *last);
      } else {
        const auto& arc = std::get<circular::Arc>(piece.job);
        last = &result.arcs;
        draw_piece(*arcs_, arc, circular::Check({&arc, 1}), arc_pen, *last);
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
