// The shapes that a model is tested in: those the project ships and the corners of the parameters.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "model/core/fields.h"

namespace cosim::test {

/// Of a design, which has them in its shapes.h.
template <class Design>
inline constexpr std::array<typename Design::Params, 0> tested_shapes{};

/// Calls check(params) for each of them until one fails; a failure says which. Not a type for each
/// shape: a check is compiled once for a design.
template <class Design, class Check>
void for_each_shape(Check check) {
  static_assert(!tested_shapes<Design>.empty(), "the design's shapes.h is included");
  for (const typename Design::Params& params : tested_shapes<Design>) {
    std::string name = Design::name;
    for (const Parameter& p : Design::parameters(params)) {
      name += p.name + std::to_string(p.value);
    }
    SCOPED_TRACE(name);
    check(params);
    if (testing::Test::HasFatalFailure()) return;
  }
}

}  // namespace cosim::test
