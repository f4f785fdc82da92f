// The shapes that the circular design's model is tested in.
#pragma once

#include "tests/designs/circular/records.h"
#include "tests/support/shape.h"

namespace cosim::test {

template <>
inline constexpr auto tested_shapes<circular::Design> = std::to_array(
    {circular::of_width(2), circular::of_width(4), circular::of_width(8), circular::of_width(12),
     circular::of_width(16), circular::of_width(24), circular::of_width(32)});

}  // namespace cosim::test
