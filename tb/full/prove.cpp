#include "tb/full/prove.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "model/core/input_error.h"
#include "tb/cli/number.h"
#include "tb/full/commands.h"
#include "tb/util/interrupt.h"
#include "tb/util/parallel.h"
#include "tb/util/process.h"
#include "tb/util/words.h"

namespace cosim::cli {

void say_limit(int limit) {
  fmt::print("an engine was stopped after {} s of processor time; give it more: --limit {}\n",
             limit, std::min(10 * limit, kLongest));
}

namespace {

// All, unless some are named; where one is not installed, nothing is proved by the other alone.
std::vector<proof::Engine> engines_of(const ProveOptions& o) {
  const auto all = o.engines ? proof::engines_of(*o.engines) : proof::all_engines();
  const bool needs_abc = std::ranges::find(all, proof::Engine::cec) != all.end();
  if (needs_abc && !is_installed("yosys-abc")) {
    throw InputError("prove: needs yosys-abc, which is not installed (apt-get install yosys)");
  }
  return all;
}

int run(const ProveOptions& o, const Registry& registry, Verdicts& verdicts) {
  const InterruptGuard interrupts;
  const int limit = static_cast<int>(whole("--limit", o.limit.value_or("300"), 1, kLongest));
  const auto jobs = o.jobs ? static_cast<unsigned>(whole("--jobs", *o.jobs, 1, 1024)) : cores();
  if (!o.mutants && (o.count || o.mutant)) {
    throw InputError(std::string(o.count ? "--count" : "--mutant") + ": belongs to --mutants");
  }
  if (o.theorems) {
    if (o.engines) throw InputError("--engines: belongs to machines, not to theorems");
    if (!is_installed("z3"))
      throw InputError("prove: needs z3, which is not installed (apt-get install z3)");
    return prove_theorems(o, limit, jobs, verdicts);
  }
  const proof::Asking asking{engines_of(o), limit, jobs};
  if (o.mutants) {
    if (o.common.junit) throw InputError("--junit: does not go with --mutants; mutate has it");
    return prove_mutants(o, registry, asking);
  }
  return prove_machines(o, asking, verdicts);
}

}  // namespace

void add_prove(const Command& program, const Registry& registry) {
  auto o = std::make_shared<ProveOptions>();
  const Command command = program.sub(prove_command.name, prove_command.help);
  command.arguments("MACHINE", o->machine, "A design, or a line of 'list'; default all");
  command.text("--rtl", o->rtl, "DIR", "Prove other RTL: DIR has a folder for each design");
  command.text("--limit", o->limit, "S", "Seconds of processor time for one answer; default 300");
  command.text("--jobs", o->jobs, "J", "Engines at a time; default one a core");
  command.text("--keep", o->keep, "DIR",
               "Keep what the engines are asked in DIR, as AIGER with the names of the model");
  command.text("--engines", o->engines, "A,B",
               "Which of cec and cadical to ask, in this order; default both");
  command.flag("--theorems", o->theorems,
               "Prove instead what the sources claim, as theorems on the models");
  command.text("--mutants", o->mutants, "N",
               "Plant at most N mutants in each: they must be refuted or proved the same. Or\n"
               "FILE.v, which has those of one machine, selected by an input mutsel");
  command.text("--count", o->count, "N", "With FILE.v: only the first N; default 100");
  command.text("--mutant", o->mutant, "K", "With FILE.v: only the one with mutsel = K");
  add_junit(command, o->common);
  add_failures(command, o->common);
  command.footer(
      "Needs yosys with yosys-abc (cec); cadical is a part of this program, and theorems need z3.\n"
      "A claim is proved if both engines prove it. An engine that is named alone decides.\n"
      "A claim that is not proved for every state is then asked from reset, by yosys-abc; cadical\n"
      "checks that proof, if an inductive invariant is found in time.\n"
      "Example: " +
      program_name() + " prove " + proof::built_machines().front().title);
  command.action([o, &registry] {
    return with_verdicts(prove_command.name, prove_command.name, o->common,
                         [&](Verdicts& verdicts) { return run(*o, registry, verdicts); });
  });
}

}  // namespace cosim::cli
