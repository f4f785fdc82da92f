#include <algorithm>

#include "tb/designs/circular/cli/arc_command.h"
#include "tb/designs/circular/cli/shape.h"
#include "tb/designs/circular/sweeps.h"
#include "tb/program/registry.h"

namespace cosim::circular {
namespace {

std::vector<Sweep> exhaustive(const CircularBench& bench, bool in_lanes) {
  constexpr int every_stop_widest = 8;
  const int every_start_widest = in_lanes ? 14 : 8;
  const int every_radius_widest = in_lanes ? 16 : 12;
  const int width = bench.params().width;
  const std::int64_t largest = (std::int64_t{1} << width) - 1;
  if (width > every_radius_widest) return {};
  if (width > every_start_widest) return {every_radius(bench, 1, largest)};
  if (width > every_stop_widest) return {every_start(bench, largest)};
  return {every_start(bench, largest), every_stop(bench, std::min<std::int64_t>(largest, 40))};
}

}  // namespace

void add_to(cli::Registry& registry);

void add_to(cli::Registry& registry) {
  registry.command(cli::add_arc);
  registry.sweeps({Design::name, "Arcs on the circular machine", "--exhaustive --width 8",
                   shape_options(), cli::for_bench_of<Design>(exhaustive),
                   "W <= 12, or 16 with --lanes auto", cli::for_bench_of<Design>(random_arcs)});
  registry.example({"Circular interpolator: R = 12, a quarter circle",
                    {"arc", "--radius", "12", "--width", "4", "--table"}});
}

}  // namespace cosim::circular
