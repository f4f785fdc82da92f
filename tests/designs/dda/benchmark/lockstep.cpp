#include "tests/benchmark/lockstep.h"

#include "VddaW16.h"
#include "VddaW16___024root.h"
#include "adapters/dda.h"
#include "tb/designs/dda/sweeps.h"

namespace cosim::dda {
namespace {

[[maybe_unused]] const bool measured =
    bench::measure<Adapter<VddaW16, Params{16}>>("dda_W16", random_job, random_lines_and_arcs);

}  // namespace
}  // namespace cosim::dda
