#include "tb/designs/dda/cli/dda_command.h"
#include "tb/designs/dda/cli/shape.h"
#include "tb/designs/dda/sweeps.h"
#include "tb/program/registry.h"

namespace cosim::dda {
namespace {

std::vector<Sweep> exhaustive(const DdaBench& bench, bool in_lanes) {
  const int every_line_widest = in_lanes ? 10 : 6;
  const int every_quarter_widest = in_lanes ? 10 : 8;
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
                   cli::for_bench_of<Design>(exhaustive), "W <= 8, or 10 with --lanes auto",
                   cli::for_bench_of<Design>(random_jobs)});
}

}  // namespace cosim::dda
