// The claims of machines, a row each.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/full/machine_of.h"
#include "tb/full/prove.h"
#include "tb/full/refuted.h"
#include "tb/full/trusted.h"
#include "tb/sim/failure.h"
#include "tb/sim/progress.h"
#include "tb/sim/stimulus_text.h"
#include "tb/util/output_file.h"
#include "tb/util/parallel.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;
using proof::Claim;
using proof::Decision;
using proof::Engine;

// A machine and what is claimed of it.
struct Claimed {
  ProveSubject subject;
  proof::Source source;
  std::vector<Claim> claims;
  ReadAs read;
  std::string error;                        // of one that cannot be read
  std::optional<proof::FromReset> machine;  // where it is asked so
  std::map<proof::Happens, FromResetAnswer> from_reset;
};

// A claim, what the engines said of it, and what was said of it from reset, if that was asked.
struct Row {
  Claimed& of;
  const Claim& claim;
  bool is_first, is_last;  // of its machine
  Decision decision{};
  bool is_decided = false;
  const FromResetAnswer* from_reset = nullptr;

  std::string name() const { return of.subject.title + ", " + claim.what; }
  // What the engines did not prove is, if it is a question that can be; what they contradict each
  // other on is not.
  bool is_asked_from_reset() const {
    return !decision.proved && !decision.disagree && claim.from_reset;
  }
};

// The RTL that is proved: what the program was built from, or what --rtl names.
proof::Source source_of(const ProveOptions& o, const ProveSubject& s) {
  proof::Source source = s.source;
  if (o.rtl) source = proof::source_in(*o.rtl, s.model.machine.design, {});
  source.constants = s.source.constants;
  return source;
}

void ask_from_reset(Row& row, const proof::Asking& asking) {
  const proof::Happens what = *row.claim.from_reset;
  Claimed& of = row.of;
  if (!of.from_reset.contains(what)) {
    if (!of.machine) of.machine.emplace(of.subject.model, proof::RtlNets(of.source));
    of.from_reset[what] = asked_from_reset(*of.machine, what, bench_of(of.subject.title),
                                           std::chrono::seconds(asking.limit), asking.jobs);
  }
  const FromResetAnswer& answer = of.from_reset[what];
  row.from_reset = &answer;
  Decision& d = row.decision;
  d.proved = answer.ever == proof::Ever::never;
  const bool adds = answer.ever == proof::Ever::open && !d.opinions.empty();
  d.verdict = answer.verdict + (adds ? "; from any state " + d.verdict : "");
}

// An engine that was not asked has no time.
std::string text_of(const Row& row, const std::vector<Engine>& engines) {
  const ProveSubject& s = row.of.subject;
  std::string text = fmt::format("{:<20} {:<48}", row.is_first ? s.title : "", row.claim.what);
  for (const Engine engine : engines) {
    std::string time = "-";
    for (const proof::Opinion& opinion : row.decision.opinions) {
      if (opinion.engine == engine) time = fmt::format("{:.2f}", opinion.solved.seconds);
    }
    text += fmt::format("{:>9}  ", time);
  }
  text += row.decision.verdict + '\n';
  if (!row.is_last) return text;
  for (const auto* wires : {&s.model.machine.registers, &s.model.machine.outputs}) {
    for (const nets::Wire& w : *wires) {
      if (w.when) {
        text += fmt::format("  compared only where it means something: {}\n", w.field.name);
      }
    }
  }
  const ReadAs& read = row.of.read;
  text += read.by.empty()
              ? fmt::format("  the RTL was not compared with a simulator: {}\n", read.why)
              : fmt::format("  the RTL: {}\n", read.by);
  for (const nets::Named& n : s.model.machine.legal) {
    text += fmt::format("  assumed of the inputs: {}\n", n.name);
  }
  return text;
}

// Its seconds are those of the slowest engine.
ci::Verdict verdict_of(const Row& row) {
  const bool is_refuted = row.decision.verdict.find("REFUTED") != std::string::npos;
  using enum ci::Verdict::End;
  ci::Verdict one{row.name(),
                  row.decision.proved ? passed
                  : is_refuted        ? failure
                                      : error,
                  is_refuted ? "refuted" : "undecided", row.decision.verdict};
  for (const proof::Opinion& opinion : row.decision.opinions) {
    one.seconds = std::max(one.seconds, opinion.solved.seconds);
  }
  return one;
}

// Each row is printed as soon as it and all before it are decided.
void decide(std::vector<Row>& rows, const proof::Asking& asking) {
  StateLine line;
  std::vector<const Claim*> claims;
  for (const Row& row : rows) claims.push_back(&row.claim);
  std::size_t known = 0, printed = 0;
  const auto print_all = [&](bool asks) {
    for (; printed < rows.size() && rows[printed].is_decided; ++printed) {
      Row& row = rows[printed];
      if (row.is_asked_from_reset()) {
        if (!asks) break;
        line.show(fmt::format("asked from reset, at most {} s: {}", asking.limit, row.name()));
        ask_from_reset(row, asking);
      }
      line.print(text_of(row, asking.engines));
    }
    if (known == rows.size()) return;
    const auto is_open = [](const Row& row) { return !row.is_decided; };
    line.show(fmt::format("{} of {} decided; next: {}", known, count(rows.size(), "claim"),
                          std::ranges::find_if(rows, is_open)->name()));
  };
  print_all(false);
  proof::decide(claims, asking, [&](std::size_t i, const Decision& decision) {
    rows[i].decision = decision;
    rows[i].is_decided = true;
    ++known;
    print_all(false);
  });
  print_all(true);
}

// A stimulus or a counterexample can be replayed only if this program was built from the same RTL.
void explain(const ProveOptions& o, const Row& row) {
  const ProveSubject& subject = row.of.subject;
  const AnyBench& bench = bench_of(subject.title);
  const auto keep = [&](const Mismatch& mismatch) {
    fmt::print("\n{}", to_text(mismatch));
    const Failure failure = leave_failure(bench, refuted_case, mismatch,
                                          {o.common.failures_folder(), o.common.window()});
    fmt::print("\n{}", to_text(failure));
  };
  Stimulus stimulus;
  if (const auto* asked = row.from_reset; asked && asked->ever == proof::Ever::yes) {
    if (asked->run.mismatch) return keep(*asked->run.mismatch);
    fmt::print("\nfrom reset, on clock {}: {}\n", asked->stimulus.clocks.size() - 1,
               fmt::join(asked->what, ", "));
    stimulus = asked->stimulus;
  } else {
    const auto found = refuted(subject.model, bench, row.decision);
    if (!found) return;
    if (found->run.mismatch) return keep(*found->run.mismatch);
    fmt::print("\n{}", to_text(found->counterexample));
    stimulus = found->stimulus;
  }
  fs::create_directories(o.common.failures_folder());
  const fs::path kept =
      fs::path(o.common.failures_folder()) / (failure_name(bench, refuted_case) + ".stim");
  write_file(kept.string(), to_text(stimulus, bench));
  fmt::print(
      "RTL as built here gives what the model gives: the counterexample is of another RTL, or of\n"
      "the gates. As a stimulus: {}\n",
      kept.string());
}

}  // namespace

int prove_machines(const ProveOptions& o, const proof::Asking& asking, Verdicts& verdicts) {
  std::vector<Claimed> subjects;
  for (ProveSubject& s : subjects_of(o.machine))
    subjects.push_back({std::move(s), {}, {}, {}, {}, {}, {}});
  const auto began = std::chrono::steady_clock::now();
  {
    StateLine line;
    line.show("reading the RTL of " + count(subjects.size(), "machine"));
    in_parallel(subjects.size(), asking.jobs, [&](std::uint64_t i) {
      Claimed& s = subjects[i];
      try {
        s.source = source_for(s.subject.model, source_of(o, s.subject));
        s.read = read_as(s.subject.model, s.source);
        if (s.read.is_wrong) {
          throw InputError(fmt::format("{}: {}", s.subject.title, s.read.wrong()));
        }
        s.claims = claims_of(s.subject.model, s.source);
        s.source.keeps_statements = true;
      } catch (const InputError& error) {
        s.error = error.what();
      }
      return true;
    });
  }
  // The others are proved all the same.
  const std::string error = subjects.front().error;
  const auto is_unread = [](const Claimed& s) { return !s.error.empty(); };
  if (std::ranges::all_of(subjects, is_unread)) throw InputError(error);
  std::string said;
  for (const Claimed& s : subjects) {
    if (!is_unread(s)) continue;
    verdicts.add({s.subject.title, ci::Verdict::End::error, "input", s.error});
    if (std::exchange(said, s.error) != s.error) leave_out(s.error);
  }
  std::erase_if(subjects, is_unread);
  std::vector<Row> rows;
  for (Claimed& s : subjects) {
    for (const Claim& c : s.claims) {
      rows.push_back({s, c, &c == &s.claims.front(), &c == &s.claims.back()});
      if (o.keep) keep_questions(*o.keep, s.subject.title, c.what, c.questions);
    }
  }
  std::string heading;
  for (const Engine e : asking.engines) heading += fmt::format("{:>7} s  ", to_text(e));
  fmt::print("{:<69}{}\n", "", heading);
  std::fflush(stdout);
  decide(rows, asking);

  std::size_t proved = 0, from_reset = 0, by_abc_alone = 0;
  bool more_time_helps = false;
  const Row* explained = nullptr;  // the first that can be
  for (const Row& row : rows) {
    const bool was_asked = row.from_reset != nullptr;
    verdicts.add(verdict_of(row));
    proved += row.decision.proved ? 1 : 0;
    from_reset += row.decision.proved && was_asked ? 1 : 0;
    by_abc_alone += row.decision.proved && was_asked && !row.from_reset->is_checked ? 1 : 0;
    if (row.decision.proved) continue;
    more_time_helps = more_time_helps || proof::timed_out({row.decision}) ||
                      (was_asked && row.from_reset->ever == proof::Ever::open);
    if (explained == nullptr && (was_asked || !row.claim.questions.terms.empty())) explained = &row;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  if (explained != nullptr) explain(o, *explained);
  const std::string by = asking.engines.size() == 1
                             ? "by " + proof::listed(asking.engines) + " alone"
                             : "by " + proof::listed(asking.engines);
  fmt::print("{} of {} proved, {}{}, in {:.1f} s\n", proved, count(rows.size(), "claim"), by,
             from_reset == 0 ? ""
             : by_abc_alone == 0
                 ? fmt::format(", but {} from reset by yosys-abc, checked", from_reset)
                 : fmt::format(", but {} from reset, {} of them by yosys-abc alone", from_reset,
                               by_abc_alone),
             took.count());
  if (more_time_helps) say_limit(asking.limit);
  return proved == rows.size() ? 0 : 1;
}

}  // namespace cosim::cli
