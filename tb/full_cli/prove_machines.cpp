// The claims of machines, a row each.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <utility>

#include "model/core/input_error.h"
#include "tb/bench/stimulus_text.h"
#include "tb/full/machine_of.h"
#include "tb/full/refuted.h"
#include "tb/full_cli/prove.h"
#include "tb/program/chosen.h"
#include "tb/proof/explain.h"
#include "tb/report/failure.h"
#include "tb/support/output_file.h"
#include "tb/support/parallel.h"
#include "tb/support/words.h"
#include "tb/sweep/progress.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;
using proof::Claim;
using proof::Decision;
using proof::Engine;

// A machine and what is claimed of it.
struct Claimed {
  ProveSubject subject;
  std::vector<Claim> claims;
  std::string error;  // of one that cannot be read
};

// The RTL that is proved: what the program was built from, or what --rtl names.
proof::Source source_of(const ProveOptions& o, const ProveSubject& s) {
  proof::Source source = s.source;
  if (o.rtl) source = proof::source_in(*o.rtl, s.formula.design, {});
  source.constants = s.source.constants;
  return source;
}

// An engine that was not asked has no time.
void print_row(const std::string& title, const Claim& claim, const Decision& decision,
               const std::vector<Engine>& engines) {
  std::string times;
  for (const Engine engine : engines) {
    std::string time = "-";
    for (const proof::Opinion& opinion : decision.opinions) {
      if (opinion.engine == engine) time = fmt::format("{:.2f}", opinion.seconds());
    }
    times += fmt::format("{:>6}  ", time);
  }
  fmt::print("{:<20} {:<48}{}{}\n", title, claim.what, times, decision.verdict);
  std::fflush(stdout);  // to be seen when it is known, in a pipe too
}

// A counterexample can be replayed only if this program was built from the same RTL.
void explain(const ProveOptions& o, const ProveSubject& subject, const Claim& claim,
             const Decision& decision, int limit) {
  const auto same = [&](const auto& b) { return b->title() == subject.title; };
  const AnyBench& bench = **std::find_if(benches().begin(), benches().end(), same);
  const auto found = refuted(subject.formula, bench, claim, decision, limit);
  if (!found) return;
  if (const auto& mismatch = found->run.mismatch) {
    fmt::print("\n{}", to_text(*mismatch));
    const Failure failure = leave_failure(bench, refuted_case, *mismatch,
                                          {o.common.failures_folder(), o.common.window()});
    fmt::print("\n{}", to_text(failure));
    return;
  }
  fmt::print("\n{}", to_text(found->counterexample));
  fs::create_directories(o.common.failures_folder());
  const fs::path kept =
      fs::path(o.common.failures_folder()) / (failure_name(bench, refuted_case) + ".stim");
  OutputFile file(kept.string());
  file.text(to_text(found->stimulus, bench));
  file.close();
  fmt::print(
      "RTL as built here gives what the model gives: the counterexample is of another RTL, or of\n"
      "the formulas. As a stimulus: {}\n",
      kept.string());
}

// On a terminal a line tells which claim was settled last, and how many are.
std::vector<Decision> decided(const std::vector<Claimed>& subjects,
                              const std::vector<const Claim*>& claims,
                              const proof::Asking& asking) {
  std::vector<std::string> names;
  for (const Claimed& s : subjects) {
    for (const Claim& c : s.claims) names.push_back(s.subject.title + ", " + c.what);
  }
  StateLine line;
  std::size_t known = 0;
  const auto say = [&](const std::string& last) {
    line.show(fmt::format("{} of {} {}", known, count(claims.size(), "claim"), last));
  };
  say("");
  return proof::decide(claims, asking, [&](std::size_t i) {
    ++known;
    say("decided; last: " + names[i]);
  });
}

}  // namespace

int prove_machines(const ProveOptions& o, const proof::Asking& asking) {
  std::vector<Claimed> subjects;
  for (ProveSubject& s : subjects_of(o.machine)) subjects.push_back({std::move(s), {}, {}});
  const auto began = std::chrono::steady_clock::now();

  in_parallel(subjects.size(), asking.jobs, [&](std::uint64_t i) {
    Claimed& s = subjects[i];
    try {
      s.claims = claims_on(s.subject.formula, s.subject.nets, source_of(o, s.subject));
    } catch (const InputError& error) {
      s.error = error.what();
    }
    return true;
  });
  // The others are proved all the same.
  const std::string error = subjects.front().error;
  const auto is_unread = [](const Claimed& s) { return !s.error.empty(); };
  if (std::all_of(subjects.begin(), subjects.end(), is_unread)) throw InputError(error);
  std::string said;
  for (const Claimed& s : subjects) {
    if (is_unread(s) && std::exchange(said, s.error) != s.error) leave_out(s.error);
  }
  std::erase_if(subjects, is_unread);
  std::vector<const Claim*> claims;
  for (const Claimed& s : subjects) {
    for (const Claim& c : s.claims) {
      claims.push_back(&c);
      if (o.scripts) keep_scripts(*o.scripts, s.subject.title, c);
    }
  }
  const std::vector<Decision> decisions = decided(subjects, claims, asking);

  std::string heading;
  for (const Engine e : asking.engines) heading += fmt::format("{:>4} s  ", to_text(e));
  fmt::print("{:<69}{}\n", "", heading);
  std::size_t proved = 0, at = 0;
  std::function<void()> explain_first;
  for (const Claimed& one : subjects) {
    const ProveSubject& s = one.subject;
    for (const Claim& claim : one.claims) {
      const Decision& d = decisions[at++];
      print_row(&claim == one.claims.data() ? s.title : "", claim, d, asking.engines);
      proved += d.proved ? 1 : 0;
      if (d.proved || explain_first || claim.terms.empty()) continue;
      explain_first = [&] { explain(o, s, claim, d, asking.limit); };
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
  fmt::print("{} of {} proved, {}, in {:.1f} s\n", proved, count(claims.size(), "claim"),
             asking.engines.size() == 1   ? "by " + proof::listed(asking.engines) + " alone"
             : asking.engines.size() == 2 ? "each by " + proof::listed(asking.engines)
                                          : "each by two of " + proof::listed(asking.engines),
             took.count());
  if (proof::timed_out(decisions)) say_limit(asking.limit);
  return proved == claims.size() ? 0 : 1;
}

}  // namespace cosim::cli
