// The shapes that the dda design's model is tested in.
#pragma once

#include "tests/designs/dda/records.h"
#include "tests/support/shape.h"

namespace cosim::test {

template <>
inline constexpr auto tested_shapes<dda::Design> = std::to_array(
    {dda::of_width(2), dda::of_width(6), dda::of_width(8), dda::of_width(16), dda::of_width(32)});

}  // namespace cosim::test
