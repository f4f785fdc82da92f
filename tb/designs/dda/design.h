// The design of the DDA at the shapes that are built, and its records as structs.
#pragma once

#include "dda_shapes.h"  // made by CMake
#include "model/dda/job.h"
#include "model/plane/steps.h"

namespace cosim::dda {

using struct_dda::Design;
using Params = Design::Params;

/// Bits of an accumulator.
constexpr int width_of(const Params& p) { return Design::parameters(p)[0].value; }

/// Holds the numbers of any width.
using Machine = Dda<32>;
constexpr bool is_busy(const Design::Outputs<Word>& outputs) {
  return bool(clocked::object_of<Machine::Out>(outputs).busy);
}
/// The step of a clock, -1 to 1 on each axis; (0, 0) where there is none.
inline Point step_of(const Design::Outputs<Word>& outputs) {
  Point step;
  Machine::for_each_step(clocked::object_of<Machine::Out>(outputs), [&](int dx, int dy) {
    step = {dx, dy};
  });
  return step;
}

}  // namespace cosim::dda
