// The bench of the dda design, compiled in one place.
#pragma once

#include "model/dda/host.h"
#include "tb/bench/design_bench.h"

namespace cosim {

extern template class DesignBench<dda::Design>;

}  // namespace cosim
