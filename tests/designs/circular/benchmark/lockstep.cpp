#include "tests/benchmark/lockstep.h"

#include "VcircularW16_ports.h"
#include "circular_shapes.h"
#include "tb/designs/circular/sweeps.h"
#include "tb/dut/named_adapter.h"

namespace cosim::circular {
namespace {

[[maybe_unused]] const bool measured =
    bench::measure<NamedAdapter<VcircularW16, Trait_circularW16>>("circular_W16", random_arc,
                                                                  random_arcs);

}  // namespace
}  // namespace cosim::circular
