#include "tests/benchmark/lockstep.h"

#include "VlinearM16N13_ports.h"
#include "linear_shapes.h"
#include "tb/designs/linear/sweeps.h"
#include "tb/dut/named_adapter.h"

namespace cosim::linear {
namespace {

[[maybe_unused]] const bool measured =
    bench::measure<NamedAdapter<VlinearM16N13, Trait_linearM16N13>>("linear_M16N13", random_line,
                                                                    random_lines);

}  // namespace
}  // namespace cosim::linear
