#include "tests/benchmark/lockstep.h"

#include "VcircularW16_ports.h"
#include "circular_shapes.h"
#include "tb/designs/circular/sweeps.h"
#include "tb/dut/named_adapter.h"

namespace cosim::circular {
namespace {

Arc arc_of(const Params& p, std::uint64_t seed, std::uint64_t i) {
  return random_arc(width_of(p), seed, i);
}

[[maybe_unused]] const bool measured =
    bench::measure<NamedAdapter<VcircularW16, Trait_circularW16>>("circular_W16", arc_of,
                                                                  random_arcs);

}  // namespace
}  // namespace cosim::circular
