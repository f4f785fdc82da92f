// The shapes that the linear design's model is tested in.
#pragma once

#include "model/linear/machine.h"
#include "tests/support/shape.h"

namespace cosim::test {

template <>
inline constexpr auto tested_shapes<linear::Design> = std::to_array<linear::Params>(
    {{2, 1}, {5, 2}, {6, 3}, {7, 1}, {8, 5}, {16, 12}, {16, 13}, {24, 21}, {32, 26}, {32, 31}});

}  // namespace cosim::test
