#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "model/circular/arc.h"
#include "model/circular/oracle.h"
#include "model/core/input_error.h"
#include "tb/cli/command.h"
#include "tb/cli/common.h"
#include "tb/cli/draw_one.h"
#include "tb/cli/number.h"
#include "tb/cli/registry.h"
#include "tb/designs/circular/cli/curve.h"
#include "tb/designs/circular/cli/shape.h"
#include "tb/designs/circular/figures.h"
#include "tb/designs/circular/sweeps.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

constexpr std::uint64_t largest_coordinate = 0xffffffff;

struct ArcOptions {
  Common common;
  Text from, radius, radius2, count;
  ShapeOptions shape{circular::shape_options()};
};

// The point of the same row or column that is next to the circle, where there is one.
std::string suggestion(const circular::Arc& arc) {
  circular::Point p = arc.from;
  (p.x > p.y ? p.x : p.y) = circular::nearest_on(std::min(p.x, p.y), arc.radius2);
  return circular::next_to_circle(p, arc.radius2) ? fmt::format("; ({}, {}) is", p.x, p.y) : "";
}

circular::Arc parse_arc(const ArcOptions& o) {
  if (o.radius.has_value() == o.radius2.has_value()) {
    throw InputError(o.radius ? "--radius: does not go with --radius2"
                              : "--radius: is needed, or --radius2");
  }
  circular::Arc arc;
  if (o.radius) {
    const std::uint64_t r = whole("--radius", *o.radius, 0, largest_coordinate);
    arc.radius2 = r * r;
  } else {
    arc.radius2 = whole("--radius2", *o.radius2, 0, largest_coordinate * largest_coordinate);
  }
  arc.from = {circular::nearest_root(arc.radius2), 0};
  if (o.from) {
    const Range range{0, largest_coordinate};
    const auto from = integers("--from", *o.from, "X,Y", {range, range});
    arc.from = {from[0], from[1]};
  }
  if (!circular::next_to_circle(arc.from, arc.radius2)) {
    throw InputError(fmt::format("--from: ({}, {}) is not next to the circle of R^2 = {}{}",
                                 arc.from.x, arc.from.y, arc.radius2, suggestion(arc)));
  }
  if (o.count) {
    arc.count = static_cast<std::int64_t>(whole("--count", *o.count, 0, std::uint64_t{1} << 40));
  }
  return arc;
}

std::string describe(const ArcOptions& o, const circular::Arc& arc) {
  return fmt::format(
      "{} from ({}, {}){}",
      o.radius ? fmt::format("R = {}", circular::nearest_root(arc.radius2))
               : fmt::format("R^2 = {}", arc.radius2),
      arc.from.x, arc.from.y,
      arc.count ? ", at most " + count(static_cast<std::uint64_t>(*arc.count), "step") : "");
}

Extent extent_of(const circular::Arc& arc) {
  const std::int64_t whole = circular::steps_to_end(arc.from, arc.radius2);
  const auto steps = static_cast<std::uint64_t>(std::min(whole, arc.count.value_or(whole)));
  const std::size_t number =
      digits(static_cast<std::uint64_t>(circular::nearest_root(arc.radius2)) + 1);
  return {steps, steps, steps, digits(steps) + 2 * number + 8};
}

int run(const ArcOptions& o) {
  const auto power_up = static_cast<std::uint32_t>(o.common.seed());
  const circular::Arc arc = parse_arc(o);
  const auto& bench = circular::bench_for(o.shape.shape(), circular::width_needed(arc.radius2));
  const GridPoint from{arc.from.x, arc.from.y};
  return draw_one<circular::Design, circular::ArcFigures>(
      {o.common, power_up, bench, describe(o, arc), arc, extent_of(arc),
       step_rows(bench, from,
                 [](const auto& outputs) { return bool(circular::out_of(outputs).running); }),
       from,
       [&](GridPoint at) {
         return circular::radial_deviation({at.x, at.y}, arc.radius2);
       },
       [&](const std::vector<Mark>& marks) {
         const GridPoint end = marks.back().at;
         return circular::curve_of(arc.from, arc.radius2, {end.x, end.y});
       }});
}

void add_arc(const Command& program) {
  auto o = std::make_shared<ArcOptions>();
  const Command command =
      program.sub("arc", "An arc of the first quadrant, anticlockwise, on the circular machine");
  command.text("--radius", o->radius, "R", "Needed, or --radius2: R in steps, 0 to 2^W - 1");
  command.text("--radius2", o->radius2, "Q", "R^2, for an R that need not be whole");
  command.text("--from", o->from, "X,Y", "A lattice point next to the circle; default R,0");
  command.text("--count", o->count, "K", "Stop after K steps through input 32");
  o->shape.add(command);
  add_drawing(command, o->common,
              "Write clock,dx,dy,x,y: a row a step, x and y after it; clock 1 is the first\n"
              "of the running machine");
  command.footer("Example: cosim arc --radius 12 --from 8,9 --csv arc.csv");
  command.action([o] { return run(*o); });
}

}  // namespace
}  // namespace cosim::cli

namespace cosim::circular {
namespace {

std::vector<Sweep> exhaustive(const CircularBench& bench, bool in_lanes) {
  constexpr int every_stop_widest = 8;
  const int every_start_widest = in_lanes ? 14 : 8;
  const int every_radius_widest = in_lanes ? 16 : 12;
  const int width = width_of(bench.params());
  const std::int64_t largest = (std::int64_t{1} << width) - 1;
  if (width > every_radius_widest) return {};
  if (width > every_start_widest) return {every_radius(bench, 1, largest)};
  if (width > every_stop_widest) return {every_start(bench, largest)};
  return {every_start(bench, largest), every_stop(bench, std::min<std::int64_t>(largest, 40))};
}

}  // namespace

void add_to(cli::Registry& registry) {
  registry.command(cli::add_arc);
  registry.sweeps({Design::name, "Arcs on the circular machine", "--exhaustive --width 8",
                   shape_options(), cli::for_bench_of<Design>(exhaustive),
                   "W <= 12, or 16 with --lanes auto", cli::for_bench_of<Design>(random_arcs)});
  registry.example({"Circular interpolator: R = 12, a quarter circle",
                    {"arc", "--radius", "12", "--width", "4", "--table"}});
}

}  // namespace cosim::circular
