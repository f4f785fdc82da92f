// The bench of the circular design, compiled in one place.
#pragma once

#include "model/circular/host.h"
#include "tb/bench/design_bench.h"

namespace cosim {

extern template class DesignBench<circular::Design>;

}  // namespace cosim
