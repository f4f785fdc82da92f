#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>

#include "model/core/input_error.h"
#include "tb/bench/stimulus_text.h"
#include "tb/cli/chosen.h"
#include "tb/cli/commands.h"
#include "tb/cli/common.h"
#include "tb/cli/number.h"
#include "tb/proof/decide.h"
#include "tb/proof/explain.h"
#include "tb/proof/machines.h"
#include "tb/proof/mutants.h"
#include "tb/proof/theorems.h"
#include "tb/report/failure.h"
#include "tb/support/interrupt.h"
#include "tb/support/output_file.h"
#include "tb/support/parallel.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;
using proof::Claim;
using proof::Decision;

constexpr int kLongest = 86400;  // seconds that a solver may be given

struct ProveOptions {
  Common common;
  std::vector<std::string> machine;
  Text rtl, limit, jobs, scripts, mutants, mutant, count;
  bool theorems = false;
};

// A machine and what is claimed of it.
struct Subject {
  std::string title;
  proof::MachineFormula formula;
  proof::Source source;
  std::vector<Claim> claims;
  std::string error{};  // of one that cannot be read
};

// The RTL that is proved: what the program was built from, or what --rtl names.
proof::Source source_of(const ProveOptions& o, const Subject& s) {
  proof::Source source = s.source;
  if (o.rtl) source = proof::source_in(*o.rtl, s.formula.design, {});
  source.constants = s.source.constants;
  return source;
}

std::vector<Subject> chosen(const std::vector<std::string>& words) {
  std::vector<Subject> all;
  std::set<std::string> refused;  // why, a line a design
  const std::string wanted = fmt::format("{}", fmt::join(words, " "));
  for (const auto& machine : proof::built_machines()) {
    if (!(machine.title + ' ').starts_with(wanted.empty() ? "" : wanted + ' ')) continue;
    const std::string design = machine.title.substr(0, machine.title.find(' '));
    constexpr const char* nothing = ": nothing can be proved of it";
    if (machine.formula == nullptr) {
      refused.insert(fmt::format("{}: {}{}", design, model_without_formula(machine), nothing));
      continue;
    }
    proof::MachineFormula formula = machine.formula();
    if (formula.unobserved.empty()) {
      all.push_back({machine.title, std::move(formula), machine.source, {}});
    } else {
      refused.insert(fmt::format("{}: registers are unobserved, {}{}", design,
                                 fmt::join(formula.unobserved, ", "), nothing));
    }
  }
  if (all.empty() && !refused.empty()) throw InputError(*refused.begin());
  for (const std::string& line : refused) fmt::print("{}\n", line);
  if (words.empty()) {
    for (const Unusable& design : unusable()) {
      std::erase_if(all, [&](const Subject& s) { return s.formula.design == design.design; });
      leave_out(design.why);
    }
  }
  if (all.empty()) {
    throw InputError(
        fmt::format("{}: is no machine that is built; see {} list", wanted, program_name()));
  }
  return all;
}

void print_row(const std::string& title, const Claim& claim, const Decision& decision) {
  std::string times;
  for (const double s : decision.seconds) times += fmt::format("{:6.2f}  ", s);
  fmt::print("{:<20} {:<32}{}{}\n", title, claim.what, times, decision.verdict);
}

// The scripts of a claim on `title`, a file each.
void keep_scripts(const std::string& folder, const std::string& title, const Claim& claim) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{}: cannot be made: {}", folder, error.message()));
  for (const proof::Query& query : claim.queries) {
    const std::string what = query.asks.size() == 1 ? query.asks.front() : "each";
    std::string name = fmt::format("{} {:.60} {}.smt2", title, claim.what, what);
    std::replace(name.begin(), name.end(), ' ', '_');
    std::replace(name.begin(), name.end(), '/', '_');
    std::erase(name, '=');  // z3 takes what has one for an option
    OutputFile file((fs::path(folder) / name).string());
    file.line("; {}: {}; {}", title, claim.what, fmt::join(query.asks, ", "));
    file.text(query.script);
    file.close();
  }
}

// A counterexample can be replayed only if this program was built from the same RTL.
void explain(const ProveOptions& o, const Subject& subject, const Claim& claim,
             const Decision& decision, int limit) {
  std::optional<proof::Counterexample> found;
  for (std::size_t v = 0; v < decision.solved.size(); ++v) {
    for (std::size_t q = 0; q < claim.queries.size() && !found; ++q) {
      if (decision.solved[v][q].answer != proof::Answer::sat) continue;
      found = proof::counterexample(
          subject.formula,
          values(proof::solvers()[v], claim.queries[q].script, claim.terms, limit));
    }
  }
  if (!found) return;
  const AnyBench* bench = nullptr;
  for (const auto& b : benches()) {
    if (b->title() == subject.title) bench = b.get();
  }
  const Stimulus stimulus = proof::stimulus_of(*found, *bench);
  const Run run = bench->replay(stimulus);
  if (run.mismatch) {
    fmt::print("\n{}", to_text(*run.mismatch));
    const Failure failure = leave_failure(*bench, "counterexample of the proof", *run.mismatch,
                                          {o.common.failures_folder(), o.common.window()});
    fmt::print("\n{}", to_text(failure));
    return;
  }
  fmt::print("\n{}", to_text(*found));
  fs::create_directories(o.common.failures_folder());
  const fs::path kept = fs::path(o.common.failures_folder()) /
                        (failure_name(*bench, "counterexample of the proof") + ".stim");
  OutputFile file(kept.string());
  file.text(to_text(stimulus, *bench));
  file.close();
  fmt::print(
      "RTL as built here gives what the model gives: the counterexample is of another RTL, or of\n"
      "the formulas. As a stimulus: {}\n",
      kept.string());
}

// As a last line.
void say_limit(int limit) {
  fmt::print("a solver was stopped after {} s of processor time; give it more: --limit {}\n", limit,
             std::min(10 * limit, kLongest));
}

// One line for each theorem, with its sentence.
int run_theorems(const ProveOptions& o, int limit, unsigned jobs) {
  std::vector<proof::Theorem> theorems;
  for (const proof::Theorem& t : proof::theorems()) {
    if (o.machine.empty() || o.machine.front() == t.design) theorems.push_back(t);
  }
  if (theorems.empty() || o.machine.size() > 1) {
    throw InputError(fmt::format("{}: is no design with theorems", fmt::join(o.machine, " ")));
  }
  std::vector<const Claim*> claims;
  for (const auto& t : theorems) {
    if (o.scripts) keep_scripts(*o.scripts, t.design, t.claim);
    claims.push_back(&t.claim);
    claims.push_back(&t.premises);
  }
  const auto decisions = proof::decide(claims, limit, jobs);
  std::size_t proved = 0;
  for (std::size_t i = 0; i < theorems.size(); ++i) {
    const Decision &claim = decisions[2 * i], &premises = decisions[2 * i + 1];
    std::string times;
    for (std::size_t v = 0; v < claim.seconds.size(); ++v) {
      times += fmt::format("{} {:.2f} s, ", proof::solvers()[v].name, claim.seconds[v]);
    }
    fmt::print("{}: {}.\n  {}{}\n", theorems[i].design, theorems[i].sentence, times, claim.verdict);
    if (!premises.proved) fmt::print("  its premises: {}\n", premises.verdict);
    proved += claim.proved && premises.proved ? 1 : 0;
  }
  fmt::print("{} of {} proved by all solvers\n", proved, count(theorems.size(), "theorem"));
  if (proof::timed_out(decisions)) say_limit(limit);
  return proved == theorems.size() ? 0 : 1;
}

// Mutants of one machine, each refuted or proved to be the same.
int run_mutants(const ProveOptions& o, int limit, unsigned jobs) {
  const std::vector<Subject> subjects = chosen(o.machine);
  if (subjects.size() != 1) throw InputError("--mutants: needs one machine");
  const proof::MachineFormula& formula = subjects.front().formula;
  const fs::path file = *o.mutants;
  if (!fs::is_regular_file(file)) throw InputError(file.string() + ": no such file");
  if (o.mutant && o.count) throw InputError("--mutant: is one, with no --count");
  const auto pick = [](const char* option, const std::string& text) {
    return static_cast<unsigned>(whole(option, text, 1, 65535));
  };
  const unsigned first = o.mutant ? pick("--mutant", *o.mutant) : 1;
  const unsigned number = o.mutant ? 1 : pick("--count", o.count.value_or("100"));

  std::vector<unsigned> numbers(number);
  std::iota(numbers.begin(), numbers.end(), first);
  const auto judged = proof::judge_mutants(formula, file, numbers, limit, jobs);
  std::size_t refuted = 0, equal = 0;
  bool timed_out = false;
  for (unsigned k = 0; k < number; ++k) {
    refuted += judged[k].refuted ? 1 : 0;
    equal += judged[k].same ? 1 : 0;
    timed_out = timed_out || judged[k].timed_out;
    if (!judged[k].same && !judged[k].refuted) {
      fmt::print("mutant {}: {}\n", first + k, judged[k].verdict);
    }
  }
  fmt::print("{}: {}, {} refuted, {} proved to be the same, {} undecided\n", subjects.front().title,
             count(number, "mutant"), refuted, equal, number - refuted - equal);
  if (timed_out) say_limit(limit);
  return refuted + equal == number ? 0 : 1;
}

int run(const ProveOptions& o) {
  const InterruptGuard interrupts;
  const int limit = static_cast<int>(whole("--limit", o.limit.value_or("300"), 1, kLongest));
  const auto jobs = o.jobs ? static_cast<unsigned>(whole("--jobs", *o.jobs, 1, 1024)) : cores();
  if (!o.mutants && (o.count || o.mutant)) {
    throw InputError(std::string(o.count ? "--count" : "--mutant") + ": belongs to --mutants");
  }
  if (o.theorems) return run_theorems(o, limit, jobs);
  if (o.mutants) return run_mutants(o, limit, jobs);
  std::vector<Subject> subjects = chosen(o.machine);
  const auto began = std::chrono::steady_clock::now();

  in_parallel(subjects.size(), jobs, [&](std::uint64_t i) {
    Subject& s = subjects[i];
    try {
      s.claims = claims_on(s.formula, source_of(o, s));
    } catch (const InputError& error) {
      s.error = error.what();
    }
    return true;
  });
  // The others are proved all the same.
  const std::string error = subjects.front().error;
  const auto is_unread = [](const Subject& s) { return !s.error.empty(); };
  if (std::all_of(subjects.begin(), subjects.end(), is_unread)) throw InputError(error);
  std::string said;
  for (const Subject& s : subjects) {
    if (is_unread(s) && std::exchange(said, s.error) != s.error) leave_out(s.error);
  }
  std::erase_if(subjects, is_unread);
  std::vector<const Claim*> claims;
  for (const Subject& s : subjects) {
    for (const Claim& c : s.claims) claims.push_back(&c);
    for (const Claim& c : s.claims) {
      if (o.scripts) keep_scripts(*o.scripts, s.title, c);
    }
  }
  const std::vector<Decision> decisions = proof::decide(claims, limit, jobs);

  std::string heading;
  for (const auto& solver : proof::solvers()) heading += fmt::format("{:>4} s  ", solver.name);
  fmt::print("{:<53}{}\n", "", heading);
  std::size_t proved = 0, at = 0;
  std::function<void()> explain_first;
  for (const Subject& s : subjects) {
    for (const Claim& claim : s.claims) {
      const Decision& d = decisions[at++];
      print_row(&claim == s.claims.data() ? s.title : "", claim, d);
      proved += d.proved ? 1 : 0;
      if (d.proved || explain_first || claim.terms.empty()) continue;
      explain_first = [&] { explain(o, s, claim, d, limit); };
    }
    for (const auto* wires : {&s.formula.registers, &s.formula.outputs}) {
      for (const proof::Wire& w : *wires) {
        if (w.when) fmt::print("  compared only where it means something: {}\n", w.field.name);
      }
    }
    for (const proof::Named& n : s.formula.legal)
      fmt::print("  assumed of the inputs: {}\n", n.name);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  if (explain_first) explain_first();
  fmt::print("{} of {} proved by all solvers, in {:.1f} s\n", proved, count(claims.size(), "claim"),
             took.count());
  if (proof::timed_out(decisions)) say_limit(limit);
  return proved == claims.size() ? 0 : 1;
}

}  // namespace

void add_prove(const Command& program) {
  auto o = std::make_shared<ProveOptions>();
  const Command command =
      program.sub("prove", "Proves that RTL and model are the same, for every state and input");
  command.arguments("MACHINE", o->machine, "A design, or a line of 'list'; default all");
  command.text("--rtl", o->rtl, "DIR", "Other RTL than that built here: a folder for each design");
  command.text("--limit", o->limit, "S", "Seconds of processor time for one answer; default 300");
  command.text("--jobs", o->jobs, "J", "Solvers at a time; default one a core");
  command.text("--scripts", o->scripts, "DIR", "Keep the scripts for the solvers in DIR");
  command.flag("--theorems", o->theorems,
               "Instead: what the sources claim, as theorems on the models");
  command.text("--mutants", o->mutants, "FILE.v",
               "Instead: the mutants of one machine, in RTL with an input mutsel");
  command.text("--count", o->count, "N", "Only the first N mutants; default 100");
  command.text("--mutant", o->mutant, "K", "Only the mutant with mutsel = K");
  add_failures(command, o->common);
  command.footer(
      "Needs yosys, cvc5 and z3; only what both solvers prove is proved.\n"
      "Example: " +
      program_name() + " prove " + proof::built_machines().front().title);
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli
