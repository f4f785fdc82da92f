#include "tb/designs/linear/cli/line_command.h"
#include "tb/designs/linear/cli/shape.h"
#include "tb/designs/linear/sweeps.h"
#include "tb/program/registry.h"

namespace cosim::linear {
namespace {

std::vector<Sweep> exhaustive(const LinearBench& bench, bool in_lanes) {
  const int widest = in_lanes ? 14 : 8;
  if (bench.params().m > widest) return {};
  return {every_line(bench)};
}

}  // namespace

void add_to(cli::Registry& registry);

void add_to(cli::Registry& registry) {
  registry.command(cli::add_line);
  registry.sweeps({Design::name, "Lines on the linear machine", "--random 1000 --seed 7",
                   shape_options(), cli::for_bench_of<Design>(exhaustive),
                   "M <= 8, or 14 with --lanes auto", cli::for_bench_of<Design>(random_lines)});
  registry.example({"Linear interpolator: BP = 27, MP = 9, code 01010",
                    {"line", "--major", "27", "--minor", "9", "--code", "01010", "--m", "5", "--n",
                     "2", "--table"}});
}

}  // namespace cosim::linear
