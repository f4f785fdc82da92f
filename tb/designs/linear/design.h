// The design of the linear machine at the shapes that are built, and its records as structs.
#pragma once

#include <bit>

#include "linear_shapes.h"  // made by CMake
#include "model/linear/job.h"
#include "model/plane/steps.h"

namespace cosim::linear {

using struct_linear::Design;
using Params = Design::Params;

struct Sizes {
  int m = 0;  ///< bits of BP and of the code UK
  int n = 0;  ///< low bits of UK that the serial multiplier takes
  constexpr int gamma() const { return m - n; }
  constexpr int word() const { return 1 << gamma(); }  ///< positions in a word
};
constexpr Sizes sizes_of(const Params& p) {
  const auto all = Design::parameters(p);
  return {all[0].value, all[1].value};
}

/// Holds the outputs of any shape.
using Machine = Linear<32, 26>;
constexpr Machine::Out out_of(const Design::Outputs<Word>& outputs) {
  return clocked::object_of<Machine::Out>(outputs);
}

}  // namespace cosim::linear
