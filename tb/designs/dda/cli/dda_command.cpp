#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <vector>

#include "model/core/input_error.h"
#include "model/dda/curve.h"
#include "model/dda/equation.h"
#include "tb/cli/command.h"
#include "tb/cli/common.h"
#include "tb/cli/draw_one.h"
#include "tb/cli/number.h"
#include "tb/cli/registry.h"
#include "tb/designs/dda/cli/shape.h"
#include "tb/designs/dda/figures.h"
#include "tb/designs/dda/sweeps.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

using dda::Point;

constexpr std::int64_t largest = 0xffffffff;

struct DdaOptions {
  Common common;
  Text line, circle, conic, from, clocks;
  Text update, preload;
  bool as_it_is = false;
  ShapeOptions shape{dda::shape_options()};
};

// Whether it is the second of two names; the first where none is given.
bool is_second(const char* name, const Text& text, const char* first, const char* second) {
  const std::string value = text.value_or(first);
  if (value != first && value != second) {
    throw InputError(fmt::format("{}: {} is not {} or {}", name, in_quotes(value), first, second));
  }
  return value == second;
}

dda::Settings settings_of(const DdaOptions& o) {
  return {
      is_second("--update", o.update, "parallel", "sequential") ? dda::Update::sequential
                                                                : dda::Update::parallel,
      is_second("--preload", o.preload, "zero", "half") ? dda::Preload::half : dda::Preload::zero,
      !o.as_it_is};
}

Point point(const char* name, const std::string& text) {
  const auto all = integers(name, text, "X,Y", {{-largest, largest}, {-largest, largest}});
  return {all[0], all[1]};
}

int bits(std::int64_t size) {
  return std::max(2, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::abs(size)))));
}

dda::Conic parse_conic(const std::string& text) {
  std::vector<Range> ranges(5, {-dda::largest_factor, dda::largest_factor});
  ranges.push_back({-dda::largest_constant, dda::largest_constant});
  const auto all = integers("--conic", text, "A,B,C,D,E,F", ranges);
  return {all[0], all[1], all[2], all[3], all[4], all[5]};
}

// What is drawn, and the bits it needs at least.
struct Work {
  std::string text;
  int width = 2;
  std::function<dda::Job(int width)> job;
};

Work parse_work(const DdaOptions& o) {
  const dda::Settings settings = settings_of(o);
  std::optional<std::int64_t> clocks;
  if (o.clocks) clocks = static_cast<std::int64_t>(whole("--clocks", *o.clocks, 0, 0xfffffff));
  if (o.line) {
    const Point to = point("--line", *o.line);
    return {fmt::format("line to ({}, {})", to.x, to.y), std::max(bits(to.x), bits(to.y)),
            [=](int width) {
              dda::Job job = line(width, to, settings);
              job.clocks = clocks;
              return job;
            }};
  }
  if (o.circle) {
    const auto radius = static_cast<std::int64_t>(whole("--circle", *o.circle, 1, largest));
    if (clocks) {
      return {fmt::format("R = {} from ({}, 0), {} clocks", radius, radius, *clocks),
              bits(radius + 8), [=](int width) { return circle(width, radius, settings, clocks); }};
    }
    return {fmt::format("R = {} from ({}, 0)", radius, radius), bits(radius), [=](int width) {
              return arc(width, {radius, 0}, {0, radius}, settings);
            }};
  }
  const dda::Conic q = parse_conic(*o.conic);
  const Point from = point("--from", needed("--from", o.from));
  const int least = std::max({bits(2 * q.a), bits(q.b), bits(2 * q.c), bits(from.x), bits(from.y)});
  return {fmt::format("conic {} from ({}, {})", *o.conic, from.x, from.y), least,
          [=](int width) { return conic(width, q, from, settings, clocks); }};
}

void check_kind(const DdaOptions& o) {
  const int kinds = (o.line ? 1 : 0) + (o.circle ? 1 : 0) + (o.conic ? 1 : 0);
  if (kinds != 1) {
    throw InputError(fmt::format("dda: one of --line, --circle and --conic is needed, {}",
                                 kinds == 0 ? "none is given" : "more are given"));
  }
  if (o.from && !o.conic) throw InputError("--from: belongs to --conic");
}

// The smallest bench that holds the work on its whole way, and the job.
std::pair<const Bench<dda::Design>*, dda::Job> chosen_for(const Shape& shape, const Work& work) {
  const auto found = matching<dda::Design>(shape);
  const auto* bench = &dda::bench_for(shape, work.width);
  for (auto at = std::ranges::find(found, bench);; ++at) {
    try {
      return {*at, work.job(dda::width_of((*at)->params()))};
    } catch (const InputError&) {
      if (at + 1 == found.end()) throw;
    }
  }
}

// The point of the curve that is next to each mark.
Curve curve_of(const dda::Job& job, const std::vector<Mark>& marks) {
  Curve curve;
  for (const Mark& mark : marks) curve.push_back(on_curve(job, {mark.at.x, mark.at.y}));
  return curve;
}

// A line takes as many clocks as the accumulators have values, a shift halves them; a quarter more
// than half as many again.
Extent extent_of(int width, const dda::Job& job) {
  const dda::Start& s = job.start;
  const auto most = static_cast<std::uint64_t>(job.clocks.value_or(std::int64_t{1} << 62));
  const auto longest = static_cast<std::uint64_t>(std::max(s.left_x, s.left_y));
  const auto all = static_cast<std::uint64_t>(s.left_x + s.left_y);
  Extent extent{most, 0, most, 8};
  if (!s.free) {
    const bool line = s.two_a == 0;
    const int used = line && s.normalise ? static_cast<int>(std::bit_width(longest)) : width;
    const std::uint64_t turn =
        (std::uint64_t{1} << used) + (line ? 0 : std::uint64_t{1} << (used - 1));
    extent.clocks = std::min(most, longest == 0 ? 0 : turn);
    extent.steps = extent.clocks < most ? longest : 0;
    extent.rows = std::min(extent.clocks, all);
  }
  extent.row += digits(extent.clocks) + 2 * digits(std::uint64_t{1} << width);
  return extent;
}

int run(const DdaOptions& o) {
  const auto power_up = static_cast<std::uint32_t>(o.common.seed());
  check_kind(o);
  const Work work = parse_work(o);
  const auto [chosen, job] = chosen_for(o.shape.shape(), work);
  const auto& bench = *chosen;
  const GridPoint from{job.start.x, job.start.y};
  return draw_one<dda::Design, dda::CurveFigures>(
      {o.common, power_up, bench, work.text, job, extent_of(dda::width_of(bench.params()), job),
       step_rows(bench, from, dda::is_busy), from,
       [drawn = &job](GridPoint at) {
         return deviation(*drawn, {at.x, at.y});
       },
       [drawn = &job](const std::vector<Mark>& marks) { return curve_of(*drawn, marks); }});
}

void add_dda(const Command& program) {
  auto o = std::make_shared<DdaOptions>();
  const Command command = program.sub("dda", "A line, a circle or a conic on the DDA");
  command.text("--line", o->line, "X,Y", "From (0, 0) to X,Y");
  command.text("--circle", o->circle, "R",
               "A quarter from R,0, anticlockwise; with --clocks as far as these go");
  command.text("--conic", o->conic, "A,B,C,D,E,F",
               "A x^2 + B xy + C y^2 + D x + E y + F = 0; an ellipse for one turn");
  command.text("--from", o->from, "X,Y", "The start of a conic");
  command.text("--clocks", o->clocks, "N", "Stop after N running clocks");
  command.text("--update", o->update, "HOW",
               "parallel (default), as the source's hardware, or sequential, its flow chart");
  command.text("--preload", o->preload, "S", "Accumulators at the start: zero (default) or half");
  command.flag("--as-it-is", o->as_it_is, "Do not shift the rates of a line up first");
  o->shape.add(command);
  add_drawing(command, o->common, "Write clock,dx,dy,x,y: a row a step, x and y after it");
  command.footer("Example: cosim dda --conic 1,1,2,0,0,-10000 --from 100,0 --width 16");
  command.action([o] { return run(*o); });
}

}  // namespace
}  // namespace cosim::cli

namespace cosim::dda {
namespace {

std::vector<Sweep> exhaustive(const DdaBench& bench, bool in_lanes) {
  const int every_line_widest = in_lanes ? 10 : 6;
  const int every_quarter_widest = in_lanes ? 10 : 8;
  const int width = width_of(bench.params());
  if (width > every_quarter_widest) return {};
  if (width > every_line_widest) return {every_quarter(bench)};
  return {every_line(bench), every_quarter(bench)};
}

}  // namespace

void add_to(cli::Registry& registry) {
  registry.command(cli::add_dda);
  registry.sweeps({Design::name, "Curves on the DDA", "--exhaustive --width 6", shape_options(),
                   cli::for_bench_of<Design>(exhaustive), "W <= 8, or 10 with --lanes auto",
                   cli::for_bench_of<Design>(random_jobs)});
}

}  // namespace cosim::dda
