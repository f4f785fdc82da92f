#include <fmt/core.h>

#include <cmath>
#include <memory>

#include "model/circular/oracle.h"
#include "model/core/input_error.h"
#include "model/core/wide.h"
#include "model/linear/oracle.h"
#include "model/toolpath/plan.h"
#include "model/toolpath/quantise.h"
#include "tb/cli/command.h"
#include "tb/cli/common.h"
#include "tb/cli/conclude.h"
#include "tb/cli/extent.h"
#include "tb/cli/number.h"
#include "tb/cli/outputs.h"
#include "tb/cli/registry.h"
#include "tb/cli/wave.h"
#include "tb/designs/circular/cli/shape.h"
#include "tb/designs/linear/cli/code_option.h"
#include "tb/designs/linear/cli/shape.h"
#include "tb/show/plot.h"
#include "tb/sim/progress.h"
#include "tb/studies/toolpath/cli/curves.h"
#include "tb/studies/toolpath/path_run.h"
#include "tb/util/json.h"
#include "tb/util/output_file.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

struct PathOptions {
  Common common;
  Text file, steps_per_mm, code;
  ShapeOptions line_shape{linear::shape_options()}, arc_shape{circular::shape_options()};
};

// The machines that had work, with what came of it.
std::vector<Outcome> outcomes_of(const AnyBench& lines, const AnyBench& arcs,
                                 const PathResult& result) {
  std::vector<Outcome> outcomes;
  const auto add = [&](const AnyBench& bench, const char* noun, const Result& r) {
    if (r.cases != 0) outcomes.push_back({&bench, count(r.cases, noun), r});
  };
  add(lines, "line", result.lines);
  add(arcs, "arc", result.arcs);
  return outcomes;
}

std::string figures(const std::string& file, double scale, const toolpath::Program& program,
                    const toolpath::Plan& plan, const PathResult& result) {
  Json json;
  json["file"] = file;
  json["steps_per_mm"] = scale;
  json["segments"] = plan.segments.size();
  json["lines"] = result.lines.cases;
  json["arcs"] = result.arcs.cases;
  json["other_axis_moves"] = program.other_axis_moves;
  json["lines_unread"] = program.lines_unread;
  json["end"] = {result.end.x, result.end.y};
  json["machine_error"] = result.max_deviation();
  json["quantisation_error"] = plan.largest_quantisation;
  json["largest_closing"] = plan.largest_closing;
  return json_text(json);
}

// A wave for each machine that had work.
Looks draw_waves(const Common& common, const AnyBench& lines, const AnyBench& arcs,
                 const PathRun& path, const PathResult& result) {
  const std::string work = "path";
  Looks all;
  const auto add = [&](const AnyBench& bench, const auto& session, const Result& r) {
    if (r.cases == 0) return;
    for (auto& one : draw_wave(common, bench, work, session, r.mismatch, bench.design())) {
      all.push_back(std::move(one));
    }
  };
  add(lines, path.lines(), result.lines);
  add(arcs, path.arcs(), result.arcs);
  return all;
}

// How far a point of a segment is off its line or circle.
double off(const toolpath::Segment& s, toolpath::Point at) {
  const toolpath::Point from{at.x - s.start.x, at.y - s.start.y};
  if (s.radius2 != 0) {
    return circular::radial_deviation({at.x - s.centre.x, at.y - s.centre.y}, s.radius2);
  }
  const toolpath::Point along{s.end.x - s.start.x, s.end.y - s.start.y};
  const double length = std::hypot(static_cast<double>(along.x), static_cast<double>(along.y));
  // Of numbers of 33 bits.
  const Int128 area = Int128{along.x} * from.y - Int128{along.y} * from.x;
  return length == 0 ? 0 : std::fabs(static_cast<double>(area)) / length;
}

// What each machine is given of a plan.
struct Extents {
  Extent lines, arcs;
};

Extents extents_of(const toolpath::Plan& plan, int gamma) {
  Extents all;
  for (const toolpath::Piece& piece : plan.pieces) {
    const auto n = static_cast<std::uint64_t>(toolpath::steps(piece));
    const bool line = std::holds_alternative<toolpath::LineJob>(piece.job);
    Extent& one = line ? all.lines : all.arcs;
    one.steps += n;
    one.clocks +=
        line ? static_cast<std::uint64_t>(linear::ticks(gamma, static_cast<std::int64_t>(n))) : n;
  }
  return all;
}

// Of the path as a whole; its clocks are its steps, of which the bar knows.
Extent whole(const Extents& parts, std::size_t segments) {
  const std::uint64_t steps = parts.lines.steps + parts.arcs.steps;
  constexpr std::size_t coordinate = 11;
  return {steps, steps, steps, digits(segments) + 2 * coordinate + 9};
}

int run(const PathOptions& o) {
  const std::uint64_t seed = o.common.seed();
  const std::string& file = *o.file;
  if (file.empty()) throw InputError("FILE: names no file");
  const double scale =
      positive("--steps-per-mm", needed("--steps-per-mm", o.steps_per_mm), toolpath::finest_grid);
  const auto rule = code_rule(o.code);
  const Shape line_shape = o.line_shape.shape();
  const Shape arc_shape = o.arc_shape.shape();
  const toolpath::Program program = toolpath::read_gcode(read_file(file), file);
  const toolpath::Plan plan = toolpath::plan(program, scale);
  if (plan.pieces.empty()) {
    throw InputError(fmt::format("{}: no motion reaches a step at {} steps/mm", file, scale));
  }
  const auto& lines = linear::bench_for(line_shape, plan.longest_line);
  const auto& arcs = circular::bench_for(arc_shape, plan.arc_width);
  const Extents parts = extents_of(plan, linear::sizes_of(lines.params()).gamma());
  const Extent extent = whole(parts, plan.segments.size());
  check_wave_clocks(o.common, parts.lines.clocks);
  check_wave_clocks(o.common, parts.arcs.clocks);
  if (o.common.plot) Series::check_steps(extent.steps);
  check_outputs(o.common, {file}, {&lines, &arcs});

  OutputFile csv(o.common.csv.value_or(""));
  csv.line("segment,dx,dy,x,y");
  fmt::print("{}: {} at {} steps/mm", one_line(file), count(plan.segments.size(), "motion"), scale);
  if (program.other_axis_moves != 0) {
    fmt::print(", {} of other axes not drawn", count(program.other_axis_moves, "move"));
  }
  fmt::print("\n");
  if (program.lines_unread != 0) {
    fmt::print("{}: the program ends in line {}; {} behind it not read\n", one_line(file),
               program.lines, count(program.lines_unread, "line"));
  }

  announce_csv(o.common, extent);

  PathRun path(lines, arcs, rule, static_cast<std::uint32_t>(seed));
  Series series;
  series.add({0, 0}, 0);
  RunProgress progress("path", extent.steps, leaves_terminal(o.common));
  std::uint64_t steps = 0;
  const PathResult result =
      path.draw(plan, [&](std::uint32_t segment, toolpath::Point step, toolpath::Point at) {
        csv.line("{},{},{},{},{}", segment, step.x, step.y, at.x, at.y);
        if (o.common.plot) series.add({at.x, at.y}, off(plan.segments[segment - 1], at));
        progress.at(++steps);
      });
  progress.clear();
  Looks looks = draw_waves(o.common, lines, arcs, path, result);

  const std::string title = fmt::format("{} at {} steps/mm", one_line(file), scale);
  const std::vector<Outcome> outcomes = outcomes_of(lines, arcs, result);
  if (o.common.plot) {
    for (const Outcome& one : outcomes) {
      series.name += (series.name.empty() ? "" : ", ") + one.bench->title();
    }
    draw_plot(*o.common.plot, {title, curves_of(pieces::work_of(plan)), {series}});
  }
  csv.close();
  for (const Outcome& one : outcomes) {
    fmt::print("{}: {}, {}\n", one.bench->title(), one.work, measured_text(one.result));
  }
  fmt::print("path: {}, ends at ({}, {})\n", count(result.steps, "step"), result.end.x,
             result.end.y);
  fmt::print("grid: largest quantisation error {}", amount(plan.largest_quantisation, "step"));
  if (plan.largest_closing != 0) {
    const auto closing = static_cast<std::uint64_t>(plan.largest_closing);
    fmt::print(", arcs closed by lines of at most {}", count(closing, "step"));
  }
  fmt::print("\n");
  return conclude(outcomes, o.common, figures(file, scale, program, plan, result), std::move(looks),
                  title);
}

void add_path(const Command& program) {
  auto o = std::make_shared<PathOptions>();
  const Command command =
      program.sub("path", "The path in X and Y of a G-code program, on both machines");
  command.argument("FILE", o->file, "The program", true);
  command.text("--steps-per-mm", o->steps_per_mm, "S", "Needed: steps of the grid to 1 mm");
  command.text("--code", o->code, "RULE", "Control codes of lines: best (default) or greedy");
  o->line_shape.add(command);
  o->arc_shape.add(command);
  add_csv(command, o->common,
          "Write segment,dx,dy,x,y: a row a step, x and y after it in steps; a segment\n"
          "is a block that moves X or Y, from 1");
  add_plot(command, o->common);
  add_wave(command, o->common,
           "Draw the run as waveforms, one a machine: FILE.linear.fst, FILE.circular.fst");
  add_failures(command, o->common);
  add_common(command, o->common);
  command.footer(
      "Each motion ends exactly on its target, rounded to the grid. On the way a line may be off\n"
      "its course along the minor axis: by 2.1 steps where it has up to 255 of them, 4.7 up to\n"
      "65535, 9.7 up to 4294967295; a step is 1/S mm.\n\n"
      "Example: cosim path part.ngc --steps-per-mm 100 --csv path.csv");
  command.action([o] { return run(*o); });
}

}  // namespace
}  // namespace cosim::cli

namespace cosim::toolpath {

void add_to(cli::Registry& registry) {
  registry.command(cli::add_path);
  registry.example({"Toolpath: a flange, 100 steps a millimetre",
                    {"path", "tests/toolpaths/flange.ngc", "--steps-per-mm", "100"}});
}

}  // namespace cosim::toolpath
