#include "tests/benchmark/lockstep.h"

#include "VddaW16_ports.h"
#include "dda_shapes.h"
#include "tb/designs/dda/sweeps.h"
#include "tb/dut/named_adapter.h"

namespace cosim::dda {
namespace {

Job job_of(const Params& p, std::uint64_t seed, std::uint64_t i) {
  return random_job(width_of(p), seed, i);
}

[[maybe_unused]] const bool measured =
    bench::measure<NamedAdapter<VddaW16, Trait_ddaW16>>("dda_W16", job_of, random_lines_and_arcs);

}  // namespace
}  // namespace cosim::dda
