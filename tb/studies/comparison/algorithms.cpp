#include "tb/studies/comparison/contest.h"

#include "model/linear/control_code.h"
#include "model/prior_art/bresenham.h"
#include "model/prior_art/midpoint_circle.h"
#include "model/prior_art/rate_multiplier.h"
#include "model/prior_art/single_axis_circle.h"
#include "model/prior_art/su875343.h"
#include "tb/designs/circular/figures.h"
#include "tb/designs/dda/figures.h"
#include "tb/designs/linear/figures.h"
#include "tb/sim/job_check.h"

namespace cosim::compare {
namespace {

using prior_art::Point;

// Keeps the points that a machine draws, and counts its clocks.
class Follower {
 public:
  explicit Follower(Drawing& drawing) : drawing_(drawing) {}
  void clock() { ++drawing_.clocks; }
  void position(std::int64_t dx, std::int64_t dy) {
    const Point at = drawing_.points.back();
    drawing_.points.push_back({at.x + dx, at.y + dy});
  }

 private:
  Drawing& drawing_;
};

class LineFollower final : public Observer<linear::Design>, Follower {
 public:
  LineFollower(Drawing& drawing, const linear::Params& p) : Follower(drawing), p_(p) {}
  void clock(std::size_t, const Compared<linear::Design>& seen) override {
    if (!linear::out_of(seen.outputs).strobe) return;
    Follower::clock();
    for_each_step(p_, seen.outputs, [this](Word dx, Word dy) { position(dx, dy); });
  }

 private:
  linear::Params p_;
};

// The clock that only sees the end does not count; the one of the sector change does.
class ArcFollower final : public Observer<circular::Design>, Follower {
 public:
  using Follower::Follower;
  void clock(std::size_t, const Compared<circular::Design>& seen) override {
    if (!circular::out_of(seen.outputs).running) return;
    if (waiting_) {
      Follower::clock();
      position(0, 0);
    }
    const Point step = circular::step_of(seen.outputs);
    waiting_ = step == Point{};
    if (waiting_) return;
    Follower::clock();
    position(step.x, step.y);
  }

 private:
  bool waiting_ = false;
};

class DdaFollower final : public Observer<dda::Design>, Follower {
 public:
  using Follower::Follower;
  void clock(std::size_t, const Compared<dda::Design>& seen) override {
    if (!dda::is_busy(seen.outputs)) return;
    if (running_) {
      Follower::clock();
      position(step_.x, step_.y);
    }
    running_ = true;
    step_ = dda::step_of(seen.outputs);
  }

 private:
  bool running_ = false;
  Point step_;
};

template <class Figures, class Design, class Job, class Follow>
Drawing in_lockstep(const Bench<Design>& bench, std::uint32_t power_up, const Job& job,
                    Drawing& drawing, Follow& follower) {
  JobCheck<Design, Figures> check(bench.params(), {&job, 1});
  Observers<Design> observers{&follower, &check};
  Run run = bench.open(power_up)->draw({&job, 1}, observers);
  drawing.bench = &bench;
  drawing.result = result_of(std::move(run), check.so_far());
  return std::move(drawing);
}

using Rule = linear::Code (*)(int, std::int64_t, std::int64_t);

template <Rule rule>
Drawing by_words(const Machines& machines, const Line& line) {
  const linear::Params p = machines.linear->params();
  const linear::Job job{{line.major, rule(linear::sizes_of(p).m, line.major, line.minor)}, {}};
  Drawing drawing{{{0, 0}}, 0, nullptr, {}};
  LineFollower follower(drawing, p);
  return in_lockstep<linear::LineFigures>(*machines.linear, machines.power_up, job, drawing,
                                          follower);
}

Drawing by_su1665343(const Machines& machines, const Arc& arc) {
  const bool whole = arc.to == circular::end_point(arc.radius2);
  circular::Arc job{arc.from, arc.radius2, {}};
  if (!whole) job.count = circular::steps_to(arc.from, arc.radius2, arc.to);
  Drawing drawing{{arc.from}, 0, nullptr, {}};
  ArcFollower follower(drawing);
  return in_lockstep<circular::ArcFigures>(*machines.circular, machines.power_up, job, drawing,
                                           follower);
}

template <class Work, class MakeJob>
Drawing by_dda(const Machines& machines, Point from, const MakeJob& make_job) {
  const dda::Job job = make_job(dda::width_of(machines.dda->params()));
  Drawing drawing{{from}, 0, nullptr, {}};
  DdaFollower follower(drawing);
  return in_lockstep<dda::CurveFigures>(*machines.dda, machines.power_up, job, drawing, follower);
}

template <dda::Preload preload>
Drawing line_by_dda(const Machines& machines, const Line& line) {
  return by_dda<Line>(machines, {0, 0}, [&](int width) {
    return dda::line(width, {line.major, line.minor}, {dda::Update::parallel, preload, true});
  });
}

template <dda::Update update, dda::Preload preload>
Drawing arc_by_dda(const Machines& machines, const Arc& arc) {
  return by_dda<Arc>(machines, arc.from, [&](int width) {
    return dda::arc(width, arc.from, arc.to, {update, preload, false});
  });
}

// A model of its own takes a clock a position.
Drawing by_model(Points points) {
  const std::uint64_t clocks = points.size() - 1;
  return {std::move(points), clocks, nullptr, {}};
}

Drawing by_rate_multiplier(const Machines& machines, const Line& line) {
  const linear::Sizes sizes = linear::sizes_of(machines.linear->params());
  Drawing drawing = by_model(prior_art::rate_multiplier(sizes.m, line));
  drawing.clocks >>= sizes.gamma();
  return drawing;
}

}  // namespace

const std::vector<Algorithm<Line>>& line_algorithms() {
  using enum dda::Preload;
  static const std::vector<Algorithm<Line>> all{
      {"su1631518", "the linear machine, best code", by_words<linear::best_code>},
      {"su1631518-greedy", "the same, greedy code", by_words<linear::greedy_code>},
      {"rate-multiplier", "its prototype: both axes by rate multipliers", by_rate_multiplier},
      {"dda", "the DDA, accumulators at 0", line_by_dda<zero>},
      {"dda-half", "the same, at half", line_by_dda<half>},
      {"bresenham", "Bresenham's line",
       [](const Machines&, const Line& line) { return by_model(prior_art::bresenham(line)); }}};
  return all;
}

const std::vector<Algorithm<Arc>>& arc_algorithms() {
  using enum dda::Preload;
  using enum dda::Update;
  static const std::vector<Algorithm<Arc>> all{
      {"su1665343", "the circular machine", by_su1665343},
      {"su875343", "its prototype: past 45 degrees along the tangent",
       [](const Machines&, const Arc& arc) { return by_model(prior_art::su875343(arc)); },
       [](const Arc& arc) { return arc.from.x > arc.from.y; },
       "an arc that starts at 45 degrees or behind"},
      {"dda", "the DDA, parallel, accumulators at 0", arc_by_dda<parallel, zero>},
      {"dda-half", "the same, at half", arc_by_dda<parallel, half>},
      {"dda-sequential", "the DDA, sequential, accumulators at 0", arc_by_dda<sequential, zero>},
      {"dda-sequential-half", "the same, at half", arc_by_dda<sequential, half>},
      {"midpoint", "the midpoint circle",
       [](const Machines&, const Arc& arc) { return by_model(prior_art::midpoint_circle(arc)); }},
      {"single-axis", "an evaluation function, one axis a step",
       [](const Machines&, const Arc& arc) {
         return by_model(prior_art::single_axis_circle(arc));
       }}};
  return all;
}

}  // namespace cosim::compare
