// The shapes that the circular design's model is tested in.
#pragma once

#include "model/circular/machine.h"
#include "tests/support/shape.h"

namespace cosim::test {

template <>
inline constexpr auto tested_shapes<circular::Design> =
    std::to_array<circular::Params>({{2}, {4}, {8}, {12}, {16}, {24}, {32}});

}  // namespace cosim::test
