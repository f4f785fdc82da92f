#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "model/core/input_error.h"
#include "tb/circular_sweeps.h"
#include "tb/cli/choose.h"
#include "tb/cli/command.h"
#include "tb/cli/conclude.h"
#include "tb/cli/number.h"
#include "tb/cli/progress.h"
#include "tb/cli/shape_options.h"
#include "tb/linear_sweeps.h"

namespace cosim::cli {
namespace {

constexpr std::uint64_t most = std::uint64_t{1} << 48;

struct Options {
  Common common;
  std::string random, hostile, jobs;
  bool exhaustive = false;
  ShapeOptions shape;
};

// What a kind of sweep means for a bench; a bench too wide to exhaust has none.
using Sweeps = std::vector<Sweep>;

Sweeps exhaustive(const Bench<linear::Design>& bench) {
  constexpr int widest = 8;
  if (bench.params().m > widest) return {};
  return {linear::every_line(bench)};
}

Sweeps exhaustive(const Bench<circular::Design>& bench) {
  constexpr int every_start_widest = 8;
  constexpr int every_radius_widest = 12;
  const int width = bench.params().width;
  const std::int64_t largest = (std::int64_t{1} << width) - 1;
  if (width > every_radius_widest) return {};
  if (width > every_start_widest) return {circular::every_radius(bench, 1, largest)};
  return {circular::every_start(bench, largest),
          circular::every_stop(bench, std::min<std::int64_t>(largest, 40))};
}

Sweep random(const Bench<linear::Design>& bench, std::uint64_t seed, std::uint64_t count) {
  return linear::random_lines(bench, seed, count);
}

Sweep random(const Bench<circular::Design>& bench, std::uint64_t seed, std::uint64_t count) {
  return circular::random_arcs(bench, seed, count);
}

template <class Design>
int run(const Options& o, const std::vector<const Bench<Design>*>& benches) {
  const std::uint64_t seed = o.common.seed();
  if ((o.exhaustive ? 1 : 0) + (o.random.empty() ? 0 : 1) + (o.hostile.empty() ? 0 : 1) != 1) {
    throw InputError("sweep: exactly one of --exhaustive, --random and --hostile is needed");
  }
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const auto threads =
      o.jobs.empty() ? cores : static_cast<unsigned>(whole("--jobs", o.jobs, 1, 1024));
  const std::uint64_t cases = o.random.empty() ? 0 : whole("--random", o.random, 1, most);
  const std::uint64_t clocks = o.hostile.empty() ? 0 : whole("--hostile", o.hostile, 1, most);

  std::vector<Outcome> outcomes;
  for (const Bench<Design>* bench : benches) {
    Sweeps sweeps;
    if (o.exhaustive) sweeps = exhaustive(*bench);
    if (cases != 0) sweeps = {random(*bench, seed, cases)};
    if (clocks != 0) sweeps = {hostile_sweep(*bench, seed, clocks)};
    for (const Sweep& sweep : sweeps) {
      ProgressLine progress(fmt::format("{}, {}", bench->title(), sweep.name));
      Outcome outcome{bench, sweep.name, run_sweep(sweep, threads, progress.callback())};
      progress.finish();
      outcomes.push_back(std::move(outcome));
      if (!outcomes.back().result.match()) return conclude(outcomes, o.common);
    }
  }
  if (outcomes.empty()) {
    throw InputError("--exhaustive: too wide to try everything; take M <= 8 or W <= 12");
  }
  return conclude(outcomes, o.common);
}

}  // namespace

void add_sweep(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("sweep", "Many cases on every built width of a design");
  command->require_subcommand(1);
  const auto common = [](CLI::App& design, const std::shared_ptr<Options>& o) {
    design.add_flag("--exhaustive", o->exhaustive,
                    "Everything, at the widths small enough for it");
    design.add_option("--random", o->random, "COUNT random cases at each width")->type_name("COUNT");
    design.add_option("--hostile", o->hostile,
                      "COUNT clocks of any value on any pin at each width")->type_name("COUNT");
    design.add_option("--jobs", o->jobs, "Threads; default: one a core")->type_name("J");
    add_common(design, o->common);
  };
  auto lines = std::make_shared<Options>();
  CLI::App* linear = command->add_subcommand("linear", "The linear machine: lines");
  common(*linear, lines);
  lines->shape.add_linear(*linear);
  linear->callback([&action, lines] {
    action = [lines] { return run(*lines, matching(lines->shape.linear())); };
  });
  auto arcs = std::make_shared<Options>();
  CLI::App* circular = command->add_subcommand("circular", "The circular machine: arcs");
  common(*circular, arcs);
  arcs->shape.add_circular(*circular);
  circular->callback([&action, arcs] {
    action = [arcs] { return run(*arcs, matching(arcs->shape.circular())); };
  });
}

}  // namespace cosim::cli
