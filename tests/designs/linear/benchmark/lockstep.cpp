#include "tests/benchmark/lockstep.h"

#include "VlinearM16N13.h"
#include "VlinearM16N13___024root.h"
#include "adapters/linear.h"
#include "tb/designs/linear/sweeps.h"

namespace cosim::linear {
namespace {

[[maybe_unused]] const bool measured = bench::measure<Adapter<VlinearM16N13, Params{16, 13}>>(
    "linear_M16N13", random_line, random_lines);

}  // namespace
}  // namespace cosim::linear
