#include "tests/benchmark/lockstep.h"

#include "VddaW16_ports.h"
#include "dda_shapes.h"
#include "tb/designs/dda/sweeps.h"
#include "tb/dut/named_adapter.h"

namespace cosim::dda {
namespace {

[[maybe_unused]] const bool measured = bench::measure<NamedAdapter<VddaW16, Trait_ddaW16>>(
    "dda_W16", random_job, random_lines_and_arcs);

}  // namespace
}  // namespace cosim::dda
