#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "model/toolpath/plan.h"
#include "tb/cli/choose.h"
#include "tb/cli/command.h"
#include "tb/cli/conclude.h"
#include "tb/cli/number.h"
#include "tb/cli/shape_options.h"
#include "tb/output_file.h"
#include "tb/path_run.h"

namespace cosim::cli {
namespace {

constexpr double finest_grid = 1e9;

struct Options {
  Common common;
  std::string file, steps_per_mm, code = "best";
  ShapeOptions shape;
};

int run(const Options& o) {
  const std::uint64_t seed = o.common.seed();
  const double scale = positive("--steps-per-mm", o.steps_per_mm, finest_grid);
  const toolpath::Program program = toolpath::read_gcode_file(o.file);
  const toolpath::Plan plan = toolpath::plan(program, scale);
  const auto& lines = choose(o.shape.linear(), plan.longest_line);
  const auto& arcs = choose(o.shape.circular(), plan.arc_width);
  const auto code = o.code == "greedy" ? linear::greedy_code : linear::best_code;

  fmt::print("{}: {} motions at {} steps/mm", o.file, plan.segments.size(), scale);
  if (program.other_axis_moves != 0) {
    fmt::print(", {} moves of other axes not drawn", program.other_axis_moves);
  }
  fmt::print("\n");

  OutputFile csv(o.common.csv);
  csv.line("segment,dx,dy,x,y");
  PathRun path(lines, arcs, code, static_cast<std::uint32_t>(seed));
  const PathResult result = path.draw(plan, [&](std::uint32_t segment, toolpath::Point step,
                                                toolpath::Point at) {
    csv.line("{},{},{},{},{}", segment, step.x, step.y, at.x, at.y);
  });
  csv.close();

  std::vector<Outcome> outcomes;
  const auto add = [&](const AnyBench& bench, const char* what, const Result& r) {
    if (r.cases == 0) return;
    outcomes.push_back({&bench, fmt::format("{} {}", r.cases, what), r});
    fmt::print("  {}: {} {}\n", bench.title(), r.cases, what);
  };
  add(lines, "lines", result.lines);
  add(arcs, "arcs", result.arcs);
  if (outcomes.empty()) outcomes.push_back({&lines, "0 lines", result.lines});

  fmt::print("  path     {} steps, ends at ({}, {})\n", result.steps, result.end.x, result.end.y);
  fmt::print("  machines at most {:.3f} steps from the quantised curve\n", result.max_deviation());
  fmt::print("  grid     the quantised curve at most {:.3f} steps from the programmed one", plan.largest_quantisation);
  if (plan.arc_width != 0) fmt::print(", arcs closed by at most {} steps", plan.largest_closing);
  fmt::print("\n");

  nlohmann::ordered_json extra;
  extra["file"] = o.file;
  extra["steps_per_mm"] = scale;
  extra["segments"] = plan.segments.size();
  extra["lines"] = result.lines.cases;
  extra["arcs"] = result.arcs.cases;
  extra["other_axis_moves"] = program.other_axis_moves;
  extra["end"] = {result.end.x, result.end.y};
  extra["machine_error"] = result.max_deviation();
  extra["quantisation_error"] = plan.largest_quantisation;
  extra["largest_closing"] = plan.largest_closing;
  return conclude(outcomes, o.common, extra.dump());
}

}  // namespace

void add_path(CLI::App& app, Action& action) {
  auto o = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("path", "The XY path of a G-code program on both machines");
  command->add_option("FILE", o->file, "The program")->required();
  command->add_option("--steps-per-mm", o->steps_per_mm, "Steps of the grid in a millimetre")
      ->required()->type_name("S");
  command->add_option("--code", o->code, "Control codes of lines: best (default) or greedy")
      ->check(CLI::IsMember({"best", "greedy"}))->type_name("RULE");
  o->shape.add_linear(*command);
  o->shape.add_circular(*command);
  add_csv(*command, o->common, "segment,dx,dy,x,y");
  add_common(*command, o->common);
  command->callback([&action, o] { action = [o] { return run(*o); }; });
}

}  // namespace cosim::cli
