#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "model/core/input_error.h"
#include "tb/cli/choose.h"
#include "tb/cli/commands.h"
#include "tb/cli/common.h"
#include "tb/cli/conclude.h"
#include "tb/cli/number.h"
#include "tb/cli/outputs.h"
#include "tb/cli/progress.h"
#include "tb/cli/shape_options.h"
#include "tb/cli/sweep_checkpoint.h"
#include "tb/designs/circular/sweeps.h"
#include "tb/designs/dda/sweeps.h"
#include "tb/designs/linear/sweeps.h"
#include "tb/support/interrupt.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

constexpr std::uint64_t most = std::uint64_t{1} << 48;

struct Options {
  Common common;
  Text random, hostile, jobs;
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

Sweeps exhaustive(const Bench<dda::Design>& bench) {
  constexpr int every_line_widest = 6;
  constexpr int every_quarter_widest = 8;
  const int width = bench.params().width;
  if (width > every_quarter_widest) return {};
  if (width > every_line_widest) return {dda::every_quarter(bench)};
  return {dda::every_line(bench), dda::every_quarter(bench)};
}

Sweep random(const Bench<linear::Design>& bench, std::uint64_t seed, std::uint64_t count) {
  return linear::random_lines(bench, seed, count);
}

Sweep random(const Bench<circular::Design>& bench, std::uint64_t seed, std::uint64_t count) {
  return circular::random_arcs(bench, seed, count);
}

Sweep random(const Bench<dda::Design>& bench, std::uint64_t seed, std::uint64_t count) {
  return dda::random_jobs(bench, seed, count);
}

void check_kind(const Options& o) {
  const int kinds = (o.exhaustive ? 1 : 0) + (o.random ? 1 : 0) + (o.hostile ? 1 : 0);
  if (kinds != 1) {
    throw InputError(fmt::format("sweep: one of --exhaustive, --random and --hostile is needed, {}",
                                 kinds == 0 ? "none is given" : "more are given"));
  }
}

// All that is to be swept, each with the bench it runs on.
template <class Design>
std::vector<std::pair<const Bench<Design>*, Sweep>> planned(
    const Options& o, const std::vector<const Bench<Design>*>& benches) {
  const std::uint64_t seed = o.common.seed();
  const std::uint64_t cases = o.random ? whole("--random", *o.random, 1, most) : 0;
  const std::uint64_t clocks = o.hostile ? whole("--hostile", *o.hostile, 1, most) : 0;
  std::vector<std::pair<const Bench<Design>*, Sweep>> all;
  for (const Bench<Design>* bench : benches) {
    Sweeps sweeps;
    if (o.exhaustive) sweeps = exhaustive(*bench);
    if (o.random) sweeps = {random(*bench, seed, cases)};
    if (o.hostile) sweeps = {hostile_sweep(*bench, seed, clocks)};
    for (Sweep& sweep : sweeps) all.emplace_back(bench, std::move(sweep));
  }
  if (all.empty()) {
    throw InputError(
        "--exhaustive: too wide to try everything; take M <= 8 or W <= 12, of the DDA W <= 8");
  }
  return all;
}

// Hostile clocks are no lines or arcs: the oracle has nothing to count.
std::string swept(const Result& r) {
  if (r.checked.jobs == 0) return count(r.clocks, "clock");
  return count(r.cases, "case") + ", " + drawn(r);
}

// The same sweep, which ends with the case it is at when it is interrupted, and counts those that
// matched.
Sweep interruptible(const Sweep& sweep, std::atomic<std::uint64_t>& matched) {
  Sweep all = sweep;
  all.run = [run = sweep.run, &matched](std::uint64_t i) {
    InterruptGuard::check();
    Result result = run(i);
    if (result.match()) ++matched;
    return result;
  };
  return all;
}

// What there is to say of an interrupted run: the sweeps finished have their lines already.
int stopped(const Interrupted& interrupted, ProgressLine& progress, const std::string& text,
            const std::vector<Outcome>& finished, std::size_t sweeps) {
  progress.finish(text);
  fmt::print("interrupted: {} of {} finished\n", finished.size(), count(sweeps, "sweep"));
  return 128 + interrupted.signal;
}

template <class Design>
int run(const Options& o, const std::vector<const Bench<Design>*>& benches) {
  check_kind(o);
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const auto threads = o.jobs ? static_cast<unsigned>(whole("--jobs", *o.jobs, 1, 1024)) : cores;
  const auto sweeps = planned(o, benches);
  check_outputs(o.common);
  std::string work =
      fmt::format("seed {}, {} hostile clocks", o.common.seed(), o.hostile.value_or("no"));
  for (const auto& [bench, sweep] : sweeps) {
    work += fmt::format("; {}, {}, {}", bench->title(), sweep.name, count(sweep.cases, "case"));
  }
  SweepCheckpoint checkpoint(o.common.checkpoint.value_or(""), work);

  std::optional<InterruptGuard> interrupts(std::in_place);
  std::vector<Outcome> outcomes;
  for (const auto& [bench, sweep] : sweeps) {
    const std::string title = fmt::format("{}, {}", bench->title(), sweep.name);
    ProgressLine progress(title);
    const Resume resume = checkpoint.resume(outcomes.size(), sweep.cases);
    std::atomic<std::uint64_t> matched{0};
    try {
      const Result swept =
          run_sweep(interruptible(sweep, matched), threads, progress.callback(), resume);
      outcomes.push_back({bench, sweep.name, swept});
    } catch (const Interrupted& interrupted) {
      const std::string text = fmt::format("{}: not finished; {} of {} matched", title,
                                           matched.load(), count(sweep.cases, "case"));
      return stopped(interrupted, progress, text, outcomes, sweeps.size());
    }
    const Result& result = outcomes.back().result;
    progress.finish(fmt::format("{}: {}", title, swept(result)));
    if (!result.match()) break;
    resume.keep(result);
  }
  interrupts.reset();  // a report to a pipe waits for its reader, and is ended as any program
  const int status = conclude(outcomes, o.common);
  checkpoint.done();
  return status;
}

void add_options(const Command& design, Options& o) {
  design.flag("--exhaustive", o.exhaustive, "Everything, at the widths small enough for it");
  design.text("--random", o.random, "COUNT", "COUNT random cases at each width");
  design.text("--hostile", o.hostile, "COUNT",
              "COUNT clocks of any value on any pin at each width");
  design.text("--jobs", o.jobs, "J", "Threads, 1 to 1024; default one a core");
  add_failures(design, o.common);
  design.text("--checkpoint", o.common.checkpoint, "FILE",
              "Keep what is done in FILE and, where it exists, go on from there");
  add_common(design, o.common);
}

constexpr const char* all_widths = "every one built";

}  // namespace

void add_sweep(const Command& program) {
  const Command command = program.sub("sweep", "Many cases on every built width of a design");

  auto lines = std::make_shared<Options>();
  const Command linear = command.sub(
      "linear", "Lines on the linear machine: one of --exhaustive, --random and --hostile");
  add_options(linear, *lines);
  lines->shape.add_linear(linear, all_widths);
  linear.footer("Example: cosim sweep linear --random 1000 --seed 7");
  linear.action([lines] { return run(*lines, matching(lines->shape.linear())); });

  auto arcs = std::make_shared<Options>();
  const Command circular = command.sub(
      "circular", "Arcs on the circular machine: one of --exhaustive, --random and --hostile");
  add_options(circular, *arcs);
  arcs->shape.add_circular(circular, all_widths);
  circular.footer("Example: cosim sweep circular --exhaustive --width 8");
  circular.action([arcs] { return run(*arcs, matching(arcs->shape.circular())); });

  auto curves = std::make_shared<Options>();
  const Command dda =
      command.sub("dda", "Curves on the DDA: one of --exhaustive, --random and --hostile");
  add_options(dda, *curves);
  curves->shape.add_dda(dda, all_widths);
  dda.footer("Example: cosim sweep dda --exhaustive --width 6");
  dda.action([curves] { return run(*curves, matching(curves->shape.dda())); });
}

}  // namespace cosim::cli
