// The shapes that the circular design's model is tested in.
#pragma once

#include "model/circular/machine.h"
#include "tests/support/shape.h"

namespace cosim::circular {

using TestedShapes =
    testing::Types<test::Shape<Design, Params{2}>, test::Shape<Design, Params{4}>,
                   test::Shape<Design, Params{8}>, test::Shape<Design, Params{12}>,
                   test::Shape<Design, Params{16}>, test::Shape<Design, Params{24}>,
                   test::Shape<Design, Params{32}>>;

}  // namespace cosim::circular
