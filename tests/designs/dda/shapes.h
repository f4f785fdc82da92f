// The shapes that the dda design's model is tested in.
#pragma once

#include "model/dda/machine.h"
#include "tests/support/shape.h"

namespace cosim::test {

template <>
inline constexpr auto tested_shapes<dda::Design> =
    std::to_array<dda::Params>({{2}, {6}, {8}, {16}, {32}});

}  // namespace cosim::test
