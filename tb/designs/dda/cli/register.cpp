#include "tb/cli/registry.h"
#include "tb/designs/dda/cli/dda_command.h"
#include "tb/designs/dda/cli/shape.h"
#include "tb/designs/dda/sweeps.h"

namespace cosim::dda {
namespace {

std::vector<Sweep> exhaustive(const DdaBench& bench) {
  constexpr int every_line_widest = 6;
  constexpr int every_quarter_widest = 8;
  const int width = bench.params().width;
  if (width > every_quarter_widest) return {};
  if (width > every_line_widest) return {every_quarter(bench)};
  return {every_line(bench), every_quarter(bench)};
}

}  // namespace

void add_to(cli::Registry& registry);

void add_to(cli::Registry& registry) {
  registry.command(cli::add_dda);
  registry.sweeps({Design::name, "Curves on the DDA", "--exhaustive --width 6", shape_options(),
                   cli::for_bench_of<Design>(exhaustive), "W <= 8",
                   cli::for_bench_of<Design>(random_jobs)});
}

}  // namespace cosim::dda
