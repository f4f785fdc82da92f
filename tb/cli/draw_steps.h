// What watches a run of a design that steps on a grid, for draw_one(): rows for --csv and points
// for --plot. Such a design has a function
//
//   for_each_step(params, outputs, take)      calls take(dx, dy) for each step of a clock, in order
//
// in its own namespace, or its model is a struct that has it (model/plane/steps.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "tb/show/plot.h"
#include "tb/sim/bench.h"
#include "tb/util/output_file.h"

namespace cosim::cli {

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

}  // namespace cosim::cli
