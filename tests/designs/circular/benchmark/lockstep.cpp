#include "tests/benchmark/lockstep.h"

#include "VcircularW16.h"
#include "VcircularW16___024root.h"
#include "adapters/circular.h"
#include "tb/designs/circular/sweeps.h"

namespace cosim::circular {
namespace {

[[maybe_unused]] const bool measured =
    bench::measure<Adapter<VcircularW16, Params{16}>>("circular_W16", random_arc, random_arcs);

}  // namespace
}  // namespace cosim::circular
