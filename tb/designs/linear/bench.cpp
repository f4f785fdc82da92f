#include "tb/designs/linear/bench.h"

namespace cosim {

template class DesignBench<linear::Design>;

}  // namespace cosim
