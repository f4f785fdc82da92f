#include <fmt/core.h>

#include <atomic>
#include <memory>
#include <optional>

#include "model/core/input_error.h"
#include "tb/cli/commands.h"
#include "tb/cli/common.h"
#include "tb/cli/conclude.h"
#include "tb/cli/full.h"
#include "tb/cli/number.h"
#include "tb/cli/registry.h"
#include "tb/cli/sweep_checkpoint.h"
#include "tb/cli/sweeps.h"
#include "tb/cli/verdicts.h"
#include "tb/sim/progress.h"
#include "tb/util/interrupt.h"
#include "tb/util/parallel.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

constexpr std::uint64_t most_cases = std::uint64_t{1} << 48;

struct SweepOptions {
  explicit SweepOptions(const DesignSweeps& d) : design(d), shape(d.shape) {}
  const DesignSweeps& design;
  Common common;
  Text random, hostile, jobs, lanes;
  bool exhaustive = false;
  ShapeOptions shape;
};

using Benches = std::vector<const AnyBench*>;

// Of a design that has more than hostile clocks.
std::string kinds_of(const DesignSweeps& design) {
  return std::string(design.exhaustive ? "--exhaustive, " : "") + "--random and --hostile";
}

void check_kind(const SweepOptions& o) {
  if (!o.design.random) {
    if (!o.hostile) throw InputError("sweep: --hostile COUNT is needed");
    return;
  }
  const int kinds = (o.exhaustive ? 1 : 0) + (o.random ? 1 : 0) + (o.hostile ? 1 : 0);
  if (kinds != 1) {
    throw InputError(fmt::format("sweep: one of {} is needed, {}", kinds_of(o.design),
                                 kinds == 0 ? "none is given" : "more are given"));
  }
}

Asked asked(const SweepOptions& o) {
  return {o.exhaustive, o.random ? whole("--random", *o.random, 1, most_cases) : 0,
          o.hostile ? whole("--hostile", *o.hostile, 1, most_cases) : 0, o.common.seed(),
          o.lanes && lanes_asked(o.lanes) != 0};
}

// Ends an interrupted run. Finished sweeps have printed their lines already.
int stopped(const Interrupted& interrupted, ProgressLine& progress, const std::string& text,
            const std::vector<Outcome>& finished, std::size_t sweeps) {
  progress.finish(text);
  fmt::print("interrupted: {} of {} finished\n", finished.size(), count(sweeps, "sweep"));
  return 128 + interrupted.signal;
}

int run(const SweepOptions& o, Verdicts& verdicts) {
  const Benches benches = matching(o.design.design, o.shape.shape());
  check_kind(o);
  const auto threads = o.jobs ? static_cast<unsigned>(whole("--jobs", *o.jobs, 1, 1024)) : cores();
  const Asked wanted = asked(o);
  const bool lanes = is_for_lanes(wanted.hostile, o.lanes);
  const Planned sweeps = planned(o.design, benches, wanted);
  if (sweeps.empty()) {
    throw InputError("--exhaustive: too wide to try everything; take " + o.design.exhaustible);
  }
  if (lanes) form().become_full(registry());
  std::string work =
      fmt::format("seed {}, {} hostile clocks", o.common.seed(), o.hostile.value_or("no"));
  for (const auto& [bench, sweep] : sweeps) {
    work += fmt::format("; {}, {}, {}", bench->title(), sweep.name, count(sweep.cases, "case"));
  }
  SweepCheckpoint checkpoint(o.common.checkpoint.value_or(""), work);

  std::optional<InterruptGuard> interrupts(std::in_place);
  std::vector<Outcome> outcomes;
  std::vector<double> seconds;  // of each
  for (const auto& [bench, sweep] : sweeps) {
    const std::string title = fmt::format("{}, {}", bench->title(), sweep.name);
    ProgressLine progress(title);
    const Resume resume = checkpoint.resume(*bench, sweep.cases);
    std::atomic<std::uint64_t> matched{0};
    try {
      const Sweep run =
          lanes ? form().in_lanes(*bench, sweep, wanted.seed, wanted.hostile, o.lanes) : sweep;
      const auto ran = [&](const Result& one) { matched += one.cases - (one.match() ? 0 : 1); };
      const Result swept = run_sweep(interruptible(run, ran), threads, progress.callback(), resume);
      outcomes.push_back({bench, sweep.name, swept});
    } catch (const Interrupted& interrupted) {
      const std::string text = fmt::format("{}: not finished; {} of {} matched", title,
                                           matched.load(), count(sweep.cases, "case"));
      return stopped(interrupted, progress, text, outcomes, sweeps.size());
    }
    const Result& result = outcomes.back().result;
    seconds.push_back(progress.finish(fmt::format("{}: {}", title, swept_text(result))));
    if (!result.match()) break;
    resume.keep(result);
  }
  interrupts.reset();  // a report to a pipe waits for its reader: there a signal ends the program
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    verdicts.add(outcomes[i], o.common.allows_nothing, seconds[i]);
  }
  const int status = conclude(outcomes, o.common);
  checkpoint.done();
  return status;
}

void add_options(const Command& design, SweepOptions& o) {
  if (o.design.exhaustive) {
    design.flag("--exhaustive", o.exhaustive,
                "Every case there is, at the widths small enough to try all");
  }
  if (o.design.random) {
    design.text("--random", o.random, "COUNT", "COUNT random cases at each width");
  }
  design.text("--hostile", o.hostile, "COUNT",
              "COUNT clocks of any value on any pin at each width");
  design.text("--lanes", o.lanes, "LANES",
              "How many cases run at once on a core: 512, 256, 64, or 0: one at a time;\n"
              "auto: as many as the processor can, as hostile clocks do in a long run;\n"
              "gpu: hostile clocks on a graphics card, or another device of OpenCL");
  design.text("--jobs", o.jobs, "J", "Threads, 1 to 1024; default one a core");
  add_junit(design, o.common);
  add_failures(design, o.common);
  add_html(design, o.common, "the figures or the first failure");
  design.text("--checkpoint", o.common.checkpoint, "FILE",
              "Keep progress in FILE and continue from it if it exists");
  add_common(design, o.common);
}

void add_design(const Command& sweep, const DesignSweeps& swept) {
  auto o = std::make_shared<SweepOptions>(swept);
  const Command design =
      sweep.sub(swept.design, swept.help + (swept.random ? ": one of " + kinds_of(swept) : ""));
  add_options(design, *o);
  o->shape.add(design, "every one built");
  design.footer(
      fmt::format("Example: {} sweep {} {}", program_name(), swept.design, swept.example));
  design.action([o] {
    return with_verdicts("sweep", o->design.design, o->common,
                         [&](Verdicts& verdicts) { return run(*o, verdicts); });
  });
}

}  // namespace

void add_sweep(const Command& program, const Registry& registry) {
  const Command command =
      program.sub("sweep", "Many cases of a design, at every width that was built");
  for (const DesignSweeps* design : all_sweeps(registry)) add_design(command, *design);
}

}  // namespace cosim::cli
