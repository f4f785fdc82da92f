// One job on one bench, drawn as the options of a command ask for.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tb/cli/conclude.h"
#include "tb/cli/extent.h"
#include "tb/cli/outputs.h"
#include "tb/cli/wave.h"
#include "tb/show/plot.h"
#include "tb/sim/bench.h"
#include "tb/sim/job_check.h"
#include "tb/sim/progress.h"
#include "tb/sim/table.h"
#include "tb/util/output_file.h"

namespace cosim::cli {

// What watches a run of a design that steps on a grid, for draw_one(): rows for --csv and points
// for --plot. Such a design has a function
//
//   for_each_step(params, outputs, take)      calls take(dx, dy) for each step of a clock, in order
//
// in its own namespace, or its model is a struct that has it (model/plane/steps.h).

/// Writes "clock,dx,dy,x,y", one row a step: x and y are the point after the step, and only clocks
/// of whose outputs `counted` holds, a member of them or a function, are counted.
template <class Design, class Counted>
class StepRows final : public Observer<Design> {
 public:
  StepRows(const typename Design::Params& p, OutputFile& file, GridPoint from, Counted counted)
      : p_(p), file_(file), at_(from), counted_(counted) {
    file_.line("clock,dx,dy,x,y");
  }
  void clock(std::size_t, const Compared<Design>& seen) override {
    if (std::invoke(counted_, seen.outputs)) ++clock_;
    for_each_step(p_, seen.outputs, [this](Word dx, Word dy) {
      at_.x += dx;
      at_.y += dy;
      file_.line("{},{},{},{},{}", clock_, dx, dy, at_.x, at_.y);
    });
  }

 private:
  typename Design::Params p_;
  OutputFile& file_;
  GridPoint at_;
  Counted counted_;
  std::uint64_t clock_ = 0;
};

/// The rows of OneRun as StepRows.
template <class Design, class Counted>
auto step_rows(const Bench<Design>& bench, GridPoint from, Counted counted) {
  return [=, p = bench.params()](OutputFile& file) {
    return std::make_unique<StepRows<Design, Counted>>(p, file, from, counted);
  };
}

/// Adds the points of a path to a picture.
template <class Design>
class StepPoints final : public Observer<Design> {
 public:
  /// How far a point is off the curve, in steps.
  using Off = std::function<double(GridPoint)>;

  StepPoints(const typename Design::Params& p, Series& series, GridPoint from, Off off)
      : p_(p), series_(series), off_(std::move(off)) {
    series_.add(from, off_(from));
  }
  void clock(std::size_t, const Compared<Design>& seen) override {
    for_each_step(p_, seen.outputs, [this](Word dx, Word dy) {
      GridPoint at = series_.marks.back().at;
      at.x += dx;
      at.y += dy;
      series_.add(at, off_(at));
    });
  }

 private:
  typename Design::Params p_;
  Series& series_;
  Off off_;
};

/// What is drawn, and what is asked of it.
template <class Design>
struct OneRun {
  const Common& common;
  std::uint32_t power_up;  ///< the seed
  const Bench<Design>& bench;
  std::string work;  ///< what the job is, in one line
  const typename HostOf<Design>::Job& job;
  Extent extent;
  /// Makes what writes the rows of --csv.
  std::function<std::unique_ptr<Observer<Design>>(OutputFile&)> rows;
  GridPoint from;
  std::function<double(GridPoint)> off;  ///< how far a point is off the curve, in steps
  /// The curve that the whole path was to follow.
  std::function<Curve(const std::vector<Mark>&)> ideal;
};

/// Shows how far a run is, and ends a run that is too long for its wave.
template <class Design>
class Watch final : public Observer<Design> {
 public:
  Watch(const Common& common, const std::string& title, const Extent& extent)
      : common_(common), progress_(title, extent.clocks, leaves_terminal(common)) {}
  void clock(std::size_t, const Compared<Design>&) override {
    if (++clocks_ > most_wave_clocks) check_wave_clocks(common_, clocks_);
    progress_.at(clocks_);
  }
  void finish() { progress_.clear(); }

 private:
  const Common& common_;
  std::uint64_t clocks_ = 0;
  RunProgress progress_;
};

/// Runs it, prints and writes what the options ask for: the exit status. Figures as JobCheck has
/// them.
template <class Design, class Figures>
int draw_one(const OneRun<Design>& one) {
  const Common& common = one.common;
  const Bench<Design>& bench = one.bench;
  check_extent(common, one.extent);
  check_outputs(common, {}, {&bench});
  OutputFile csv(common.csv.value_or(""));
  const auto rows = one.rows(csv);
  Series path{bench.title(), {}};
  StepPoints<Design> points(bench.params(), path, one.from, one.off);

  fmt::print("{}: {}\n", bench.title(), one.work);
  announce_csv(common, one.extent);
  Watch<Design> watch(common, bench.title(), one.extent);
  JobCheck<Design, Figures> check(bench.params(), {&one.job, 1});
  Observers<Design> observers{&check, rows.get(), &watch};
  if (common.plot) observers.add(points);
  std::unique_ptr<Table<Design>> table;
  if (common.table) observers.add(*(table = std::make_unique<Table<Design>>(bench.params())));

  const auto session = bench.open(one.power_up);
  Run run = session->draw({&one.job, 1}, observers);
  watch.finish();
  if (common.plot) draw_plot(*common.plot, {one.work, {one.ideal(path.marks)}, {path}});
  const Looks looks = draw_wave(common, bench, one.work, *session, run.mismatch);
  csv.close();
  const Outcome outcome = outcome_of(bench, one.work, std::move(run), check);
  fmt::print("drawn: {}\n", measured_text(outcome.result));
  return conclude({outcome}, common, "{}", looks);
}

}  // namespace cosim::cli
