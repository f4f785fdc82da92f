#include "tb/designs/circular/bench.h"

namespace cosim {

template class DesignBench<circular::Design>;

}  // namespace cosim
