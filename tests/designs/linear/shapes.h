// The shapes that the linear design's model is tested in.
#pragma once

#include "tests/designs/linear/records.h"
#include "tests/support/shape.h"

namespace cosim::test {

template <>
inline constexpr auto tested_shapes<linear::Design> =
    std::to_array({linear::of(2, 1), linear::of(5, 2), linear::of(6, 3), linear::of(7, 1),
                   linear::of(8, 5), linear::of(16, 12), linear::of(16, 13), linear::of(24, 21),
                   linear::of(32, 26), linear::of(32, 31)});

}  // namespace cosim::test
