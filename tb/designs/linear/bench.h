// The bench of the linear design, compiled in one place.
#pragma once

#include "model/linear/host.h"
#include "tb/bench/design_bench.h"

namespace cosim {

extern template class DesignBench<linear::Design>;

}  // namespace cosim
