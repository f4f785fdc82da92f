// The shapes that the dda design's model is tested in.
#pragma once

#include "model/dda/machine.h"
#include "tests/support/shape.h"

namespace cosim::dda {

using TestedShapes = testing::Types<test::Shape<Design, Params{2}>, test::Shape<Design, Params{6}>,
                                    test::Shape<Design, Params{8}>, test::Shape<Design, Params{16}>,
                                    test::Shape<Design, Params{32}>>;

}  // namespace cosim::dda
