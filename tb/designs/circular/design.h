// The design of the circular machine at the shapes that are built, and its records as structs.
#pragma once

#include "circular_shapes.h"  // made by CMake
#include "model/circular/arc.h"
#include "model/plane/steps.h"

namespace cosim::circular {

using struct_circular::Design;
using Params = Design::Params;

/// Bits of a coordinate.
constexpr int width_of(const Params& p) { return Design::parameters(p)[0].value; }

/// Holds the numbers of any width.
using Machine = Circular<32>;
constexpr Machine::Out out_of(const Design::Outputs<Word>& outputs) {
  return clocked::object_of<Machine::Out>(outputs);
}
/// The step of a clock, (0, 0) where there is none.
constexpr Point step_of(const Design::Outputs<Word>& outputs) {
  const Machine::Out out = out_of(outputs);
  return {-static_cast<Word>(out.step_x), static_cast<Word>(out.step_y)};
}

}  // namespace cosim::circular
