// The shapes that the linear design's model is tested in.
#pragma once

#include "model/linear/machine.h"
#include "tests/support/shape.h"

namespace cosim::linear {

using TestedShapes =
    testing::Types<test::Shape<Design, Params{2, 1}>, test::Shape<Design, Params{5, 2}>,
                   test::Shape<Design, Params{6, 3}>, test::Shape<Design, Params{7, 1}>,
                   test::Shape<Design, Params{8, 5}>, test::Shape<Design, Params{16, 12}>,
                   test::Shape<Design, Params{16, 13}>, test::Shape<Design, Params{24, 21}>,
                   test::Shape<Design, Params{32, 26}>, test::Shape<Design, Params{32, 31}>>;

}  // namespace cosim::linear
