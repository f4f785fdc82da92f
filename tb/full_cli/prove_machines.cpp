// The claims of machines, a row each.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
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

// What the engines said of a claim, and what was said of it from reset, if that was asked.
struct Decided {
  Decision decision;
  const FromResetAnswer* from_reset = nullptr;
};

// A machine and what is claimed of it.
struct Claimed {
  ProveSubject subject;
  proof::Source source;
  std::vector<Claim> claims;
  std::string error;  // of one that cannot be read
  std::vector<Decided> decided;
  std::map<proof::Happens, FromResetAnswer> from_reset;  // of what was asked so
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

const AnyBench& bench_of(const ProveSubject& subject) {
  const auto same = [&](const auto& b) { return b->title() == subject.title; };
  return **std::find_if(benches().begin(), benches().end(), same);
}

// What the engines did not prove is asked from reset, if it is a question that can be; one that
// they contradict each other on is not.
void ask_from_reset(Claimed& one, const proof::Asking& asking) {
  std::optional<proof::FromReset> machine;
  for (std::size_t i = 0; i < one.claims.size(); ++i) {
    const auto& what = one.claims[i].from_reset;
    Decision& d = one.decided[i].decision;
    if (d.proved || d.disagree || !what) continue;
    if (!one.from_reset.contains(*what)) {
      if (!machine) machine.emplace(one.subject.nets, proof::RtlNets(one.source));
      one.from_reset[*what] = asked_from_reset(*machine, *what, bench_of(one.subject),
                                               std::chrono::seconds(asking.limit), asking.jobs);
    }
    const FromResetAnswer& answer = one.from_reset[*what];
    one.decided[i].from_reset = &answer;
    d.proved = answer.ever == proof::Ever::never;
    const bool adds = answer.ever == proof::Ever::open && !d.opinions.empty();
    d.verdict = answer.verdict + (adds ? "; from any state " + d.verdict : "");
  }
}

// A stimulus or a counterexample can be replayed only if this program was built from the same RTL.
void explain(const ProveOptions& o, const Claimed& one, const Claim& claim, const Decided& decided,
             int limit) {
  const AnyBench& bench = bench_of(one.subject);
  const auto keep = [&](const Mismatch& mismatch) {
    fmt::print("\n{}", to_text(mismatch));
    const Failure failure = leave_failure(bench, refuted_case, mismatch,
                                          {o.common.failures_folder(), o.common.window()});
    fmt::print("\n{}", to_text(failure));
  };
  Stimulus stimulus;
  if (const auto* asked = decided.from_reset; asked && asked->ever == proof::Ever::yes) {
    if (asked->run.mismatch) return keep(*asked->run.mismatch);
    fmt::print("\nfrom reset, on clock {}: {}\n", asked->stimulus.clocks.size() - 1,
               fmt::join(asked->what, ", "));
    stimulus = asked->stimulus;
  } else {
    const auto found = refuted(one.subject.formula, bench, claim, decided.decision, limit);
    if (!found) return;
    if (found->run.mismatch) return keep(*found->run.mismatch);
    fmt::print("\n{}", to_text(found->counterexample));
    stimulus = found->stimulus;
  }
  fs::create_directories(o.common.failures_folder());
  const fs::path kept =
      fs::path(o.common.failures_folder()) / (failure_name(bench, refuted_case) + ".stim");
  OutputFile file(kept.string());
  file.text(to_text(stimulus, bench));
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
  for (ProveSubject& s : subjects_of(o.machine))
    subjects.push_back({std::move(s), {}, {}, {}, {}, {}});
  const auto began = std::chrono::steady_clock::now();

  in_parallel(subjects.size(), asking.jobs, [&](std::uint64_t i) {
    Claimed& s = subjects[i];
    try {
      s.source = source_for(s.subject.formula, source_of(o, s.subject));
      s.claims = claims_of(s.subject.formula, s.subject.nets, s.source);
      s.source.keeps_statements = true;
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
  auto next = decided(subjects, claims, asking);
  auto at = next.begin();
  for (Claimed& one : subjects) {
    for (std::size_t i = 0; i < one.claims.size(); ++i) one.decided.push_back({std::move(*at++)});
    ask_from_reset(one, asking);
  }

  std::string heading;
  for (const Engine e : asking.engines) heading += fmt::format("{:>4} s  ", to_text(e));
  fmt::print("{:<69}{}\n", "", heading);
  std::size_t proved = 0, from_reset = 0;
  bool more_time_helps = false;
  std::function<void()> explain_first;
  for (const Claimed& one : subjects) {
    const ProveSubject& s = one.subject;
    for (std::size_t i = 0; i < one.claims.size(); ++i) {
      const Claim& claim = one.claims[i];
      const Decided& decided = one.decided[i];
      const Decision& d = decided.decision;
      print_row(i == 0 ? s.title : "", claim, d, asking.engines);
      const bool was_asked = decided.from_reset != nullptr;
      proved += d.proved ? 1 : 0;
      from_reset += d.proved && was_asked ? 1 : 0;
      if (d.proved) continue;
      more_time_helps = more_time_helps || proof::timed_out({d}) ||
                        (was_asked && decided.from_reset->ever == proof::Ever::open);
      if (explain_first || (claim.terms.empty() && !was_asked)) continue;
      explain_first = [&] { explain(o, one, claim, decided, asking.limit); };
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
  const std::string by =
      asking.engines.size() == 1   ? "by " + proof::listed(asking.engines) + " alone"
      : asking.engines.size() == 2 ? "each by " + proof::listed(asking.engines)
                                   : "each by two of " + proof::listed(asking.engines);
  fmt::print(
      "{} of {} proved, {}{}, in {:.1f} s\n", proved, count(claims.size(), "claim"), by,
      from_reset == 0 ? "" : fmt::format(", but {} from reset by yosys-abc alone", from_reset),
      took.count());
  if (more_time_helps) say_limit(asking.limit);
  return proved == claims.size() ? 0 : 1;
}

}  // namespace cosim::cli
