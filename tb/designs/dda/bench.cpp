#include "tb/designs/dda/bench.h"

namespace cosim {

template class DesignBench<dda::Design>;

}  // namespace cosim
