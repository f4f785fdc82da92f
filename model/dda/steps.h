// What the DDA's outputs say: the step of a clock.
#pragma once

#include "model/dda/conic.h"
#include "model/dda/machine.h"

namespace cosim::dda {

/// The step of a clock, -1 to 1 on each axis; (0, 0) where there is none.
constexpr Point step_of(const Outputs<Word>& out) {
  return {out.x_up - out.x_down, out.y_up - out.y_down};
}

/// Calls take(dx, dy) for the step of a clock, where there is one.
template <class Take>
void for_each_step(const Params&, const Outputs<Word>& out, Take take) {
  const Point step = step_of(out);
  if (!(step == Point{})) take(step.x, step.y);
}

}  // namespace cosim::dda
