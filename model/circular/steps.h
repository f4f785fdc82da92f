// What the circular machine's outputs say: the step of a clock.
#pragma once

#include "model/circular/arc.h"
#include "model/circular/machine.h"

namespace cosim::circular {

/// The step of a clock, (0, 0) where there is none: up, to the left or both.
constexpr Point step_of(const Outputs<Word>& out) { return {-out.step_x, out.step_y}; }

/// Calls take(dx, dy) for the step of a clock, where there is one.
template <class Take>
void for_each_step(const Params&, const Outputs<Word>& out, Take take) {
  const Point step = step_of(out);
  if (!(step == Point{})) take(step.x, step.y);
}

}  // namespace cosim::circular
