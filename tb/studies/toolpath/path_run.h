// Draws a planned toolpath on a linear and a circular machine, both in lockstep for the whole of
// it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "model/toolpath/plan.h"
#include "tb/designs/circular/design.h"
#include "tb/designs/linear/design.h"
#include "tb/sim/bench.h"
#include "tb/sim/sweep.h"

namespace cosim {

/// What came of a path. `cases` of a machine's result counts the pieces it drew.
struct PathResult {
  Result lines;
  Result arcs;
  std::uint64_t steps = 0;
  toolpath::Point end;

  bool match() const { return lines.match() && arcs.match(); }
  /// The largest distance of a point from its piece's quantised curve, in steps.
  double max_deviation() const;
};

/// Called for each elementary step: its segment, the step (dx, dy) and the position after it.
using StepSink =
    std::function<void(std::uint32_t segment, toolpath::Point step, toolpath::Point at)>;
/// Chooses the control code of a line: (m, major, minor).
using CodeChooser = std::function<linear::Code(int, std::int64_t, std::int64_t)>;

class PathRun {
 public:
  /// plan.longest_line < 2^m of `lines`, plan.arc_width <= the width of `arcs` for all plans drawn.
  PathRun(const Bench<linear::Design>& lines, const Bench<circular::Design>& arcs, CodeChooser code,
          std::uint32_t power_up);

  /// Draws the plan from (0, 0), to its end or to the first difference, be it of RTL and model, of
  /// machine and oracle, or of a segment's end and its target.
  PathResult draw(const toolpath::Plan& plan, const StepSink& sink);

  const Session<linear::Design>& lines() const { return *lines_; }
  const Session<circular::Design>& arcs() const { return *arcs_; }

 private:
  linear::Params line_params_;
  circular::Params arc_params_;
  std::unique_ptr<Session<linear::Design>> lines_;
  std::unique_ptr<Session<circular::Design>> arcs_;
  CodeChooser code_;
};

}  // namespace cosim
