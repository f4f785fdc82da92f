#include "tb/mutation/built.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "model/core/input_error.h"
#include "tb/mutation/campaign.h"
#include "tb/mutation/drawn.h"
#include "tb/mutation/subject.h"
#include "tb/proof/from_reset.h"
#include "tb/proof/judge.h"
#include "tb/proof/machines.h"
#include "tb/sim/failure.h"
#include "tb/sim/report.h"
#include "tb/sim/stimulus_text.h"
#include "tb/util/draft.h"
#include "tb/util/interrupt.h"
#include "tb/util/json.h"
#include "tb/util/output_file.h"
#include "tb/util/parallel.h"
#include "tb/util/place.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tb/util/stack.h"

namespace cosim::mutation {
namespace {

namespace fs = std::filesystem;

// The folder that a surviving mutant leaves: one that no stimulus and no proof told from the RTL.
//
//   report.txt   what it is, what was tried, how to give it to the solvers or, where nothing can be
//                proved, how to declare it
//   report.json  the same for a program
//   mutants.v    the RTL with its mutants; mutsel is the number

// Thousands of cases by what they are called in front of their number, and how many there are.
std::map<std::string, std::size_t> kinds_of(const std::vector<Case>& cases) {
  std::map<std::string, std::size_t> kinds;
  for (const Case& c : cases) ++kinds[c.name.substr(0, c.name.find_last_not_of(" 0123456789") + 1)];
  return kinds;
}

// Writes root/<design>-<parameters>-mutant-<number> and returns it. `prover`: how a person calls
// what proves, or "" where nothing can be proved; `apart`: the state that tells it from the RTL
// without it, where one is known.
// InputError where it cannot be written.
std::filesystem::path leave_survivor(const Subject& subject, unsigned mutant,
                                     const std::string& prover, const std::string& apart,
                                     const std::filesystem::path& root) {
  const std::string title = subject.bench().title();
  const std::string& what = subject.mutants()[mutant - 1];
  Draft draft(root, failure_name(subject.bench(), fmt::format("mutant {}", mutant)));
  const std::string prove = fmt::format("{} {} --mutants {} --mutant {}", prover, title,
                                        (draft.target() / "mutants.v").string(), mutant);

  Json json{{"verdict", "survived"}, {"design", subject.bench().design()}};
  json["parameters"] = parameters(subject.bench());
  json["mutant"] = mutant;
  json["what"] = what;
  std::string text = fmt::format(
      "{}: mutant {} survived: {}\nNo proof that it is the same machine, and RTL and model part on "
      "no clock of these runs\n",
      title, mutant, what);
  for (const auto& [kind, runs] : kinds_of(subject.cases().all)) {
    text += fmt::format("  {}: {}\n", kind, runs);
    json["stimuli"][kind] = runs;
  }
  if (!apart.empty()) {
    text += "They part " + apart +
            "If that state is never reached, let invariant() of the model say so.\n";
  }
  if (prover.empty()) {
    text += fmt::format(
        "No engine can decide it. Rare transactions of a stream come more often with draws() or "
        "arranged() in the model. If the circuit is the same, this is its line in the file of "
        "mutate --equivalent:\n  {}: {} -- REASON\n",
        title, what);
  } else {
    json["prove"] = prove;
    text += fmt::format("To have the solvers look for a state in which they part:\n  {}\n", prove);
  }

  draft.write("report.txt", text);
  draft.write("report.json", json_text(json, 1) + '\n');
  const Scratch scratch;
  const auto verilog = scratch.path() / "mutants.v";
  subject.write_verilog({mutant}, verilog);
  draft.write("mutants.v", read_file(verilog.string()));
  draft.finish_replacing();
  return draft.target();
}

// A mutant that no stimulus kills and that is not proved the same from every state: can it be told
// from the model from reset on? It is asked of proof/from_reset.h.
/// What the stimulus is called that kills such a mutant.
constexpr const char* from_reset_case = "a stimulus from reset";

// The mutant and the model, from reset.
proof::FromReset product_of(const Subject& subject, const proof::BuiltMachine& machine,
                            unsigned mutant) {
  const Scratch scratch;
  const auto verilog = scratch.path() / "mutants.v";
  subject.write_verilog({mutant}, verilog);
  const nets::Model model = machine.nets();
  const proof::Source source =
      proof::read_for(model.machine, {{fs::absolute(verilog)}, machine.source.top, {}});
  return {model, proof::RtlNets(source), {{"mutsel", mutant}}};
}

// The file of that stimulus.
fs::path stimulus_of(const Subject& subject, unsigned mutant, const fs::path& root) {
  return root / (failure_name(subject.bench(), fmt::format("mutant {}", mutant)) + ".stim");
}

// Equivalent where it is proved; killed where a stimulus does it in a run, not only on the nets:
// that is kept in the folder `root`, which is made. Else open. Takes `limit` at the most.
Outcome from_reset(const Subject& subject, const proof::BuiltMachine& machine, unsigned mutant,
                   std::chrono::seconds limit, const fs::path& root) {
  const AnyBench& bench = subject.bench();
  const auto found = product_of(subject, machine, mutant)
                         .ask(proof::Happens::differ, std::chrono::steady_clock::now() + limit, 1);
  if (found.reached.ever == proof::Ever::never) return {Outcome::End::equivalent, "", 0, ""};
  if (found.reached.ever == proof::Ever::open) return {};
  Stimulus stimulus{bench.title(), fmt::format("kills mutant {}", mutant), 1, {}, found.clocks};
  // What no reset reaches is as it powers up.
  constexpr std::uint32_t power_ups = 16;
  for (; stimulus.power_up <= power_ups; ++stimulus.power_up) {
    // Which engine found it is not said: that may be another one the next time.
    const Case one{from_reset_case, [&] { return bench.replay(stimulus); },
                   [&](const Watch& watch) { bench.watch_stimulus(stimulus, watch); },
                   stimulus.power_up};
    Outcome outcome = subject.attack(mutant, one);
    if (outcome.end != Outcome::End::killed) continue;
    fs::create_directories(root);
    write_file(stimulus_of(subject, mutant, root).string(), to_text(stimulus, bench));
    return outcome;
  }
  return {};
}

constexpr int kLimit = 60;  // seconds of an engine for one mutant

/// The engines, on the nets of a subject's model; nobody where there are none.
class Asked {
 public:
  Asked(const Subject& subject, const proof::BuiltMachine& machine, bool any,
        const std::vector<proof::Engine>& which)
      : subject_(subject) {
    if (!any) return;
    model_ = machine.nets();
    judge_.emplace(*model_, machine.source.top, proof::Asking{.engines = which, .limit = kLimit});
  }

  std::vector<bool> prove(const std::vector<unsigned>& mutants) {
    if (!judge_) return std::vector<bool>(mutants.size());
    std::vector<bool> proved;
    const Scratch scratch;
    for (const auto& judged : judge_->judge(written(mutants, scratch), mutants)) {
      proved.push_back(judged.same);
    }
    return proved;
  }
  std::string told_apart(unsigned mutant) const {
    const Scratch scratch;
    return judge_ ? judge_->told_apart(written({mutant}, scratch), mutant) : "";
  }

 private:
  std::filesystem::path written(const std::vector<unsigned>& mutants,
                                const Scratch& scratch) const {
    const auto verilog = scratch.path() / "mutants.v";
    subject_.write_verilog(mutants, verilog);
    return verilog;
  }

  const Subject& subject_;
  std::optional<nets::Model> model_;
  std::optional<proof::Judge> judge_;
};

struct Options {
  std::string shape, results, written, failures = "failures", prover = "scripts/prove";
  std::optional<std::string> verilog, engines;
  std::optional<unsigned> draw;
  bool unproved = false, about = false;
  unsigned mutants = 0, threads = cosim::cores();
  Part part;
};

int campaign_on(const Subject& subject, const proof::BuiltMachine& machine, const Options& o) {
  if (o.about) {
    fmt::print("{}\n{}\n", subject.bench().title(), subject.mutants().size());
    return 0;
  }
  if (o.results.empty()) throw InputError("RESULTS is required");
  const auto which = o.engines ? proof::engines_of(*o.engines) : proof::all_engines();
  std::string work = fmt::format("{} mutants of {}, {} from {}", subject.mutants().size(),
                                 subject.bench().title(), o.part.count, o.part.first);
  for (const proof::Engine e : which) work += ", " + to_text(e);
  Checkpoint checkpoint(o.results + kept_as, work);
  const bool proves = !o.unproved && machine.is_provable();
  const Asker asker = [&](unsigned mutant, std::chrono::seconds limit) {
    if (!proves) return Outcome{};
    return from_reset(subject, machine, mutant, limit, o.failures);
  };
  Asked asked(subject, machine, proves, which);
  const Prover prover = [&](const auto& mutants) { return asked.prove(mutants); };
  const Campaign campaign = run_campaign(subject, prover, asker, o.threads, checkpoint, o.part);
  write_file(o.results, to_json(subject, campaign));
  checkpoint.done();
  for (std::size_t i = 0; i < campaign.outcomes.size(); ++i) {
    const auto mutant = static_cast<unsigned>(campaign.first + i);
    if (campaign.outcomes[i].stimulus == from_reset_case) {
      fmt::print("found from reset: {}, stimulus kept in: {}\n", subject.mutants()[mutant - 1],
                 stimulus_of(subject, mutant, o.failures).string());
    }
    if (campaign.outcomes[i].end != Outcome::End::survived) continue;
    const auto kept = leave_survivor(subject, mutant, machine.is_provable() ? o.prover : "",
                                     asked.told_apart(mutant), o.failures);
    fmt::print("survived: {}, kept in: {}\n", subject.mutants()[mutant - 1], kept.string());
  }
  return campaign.count(Outcome::End::survived) == 0 ? 0 : 1;
}

// Registers that yosys would lose are named to it.
std::vector<std::string> registers_of(const AnyBench& bench) {
  std::vector<std::string> nets;
  const auto fields = bench.compared();
  for (std::size_t i = 0; i < bench.registers(); ++i) {
    const std::string net = net_path(fields[i].net).path;
    if (nets.empty() || nets.back() != net) nets.push_back(net);
  }
  return nets;
}

template <class All, class IsIt>
const auto& one_of(const All& all, const std::string& title, IsIt is_it) {
  const auto found = std::ranges::find_if(all, is_it);
  if (found == all.end())
    throw InputError(fmt::format("{} is not built; see {} list", in_quotes(title), program_name()));
  return *found;
}

int run(const Options& o, Cases (*cases)(const AnyBench&)) {
  const AnyBench& bench =
      *one_of(benches(), o.shape, [&](const auto& b) { return b->title() == o.shape; });
  const proof::BuiltMachine& machine =
      one_of(proof::built_machines(), o.shape, [&](const auto& m) { return m.title == o.shape; });
  proof::Source source = machine.source;
  source.parameters = bench.parameters();
  source.kept = registers_of(bench);
  source.written = o.written;
  const Subject subject(bench, cases(bench), source, o.mutants);
  if (o.draw) {
    draw(subject, *o.draw, o.results);
    return 0;
  }
  if (!o.verilog) return campaign_on(subject, machine, o);
  std::vector<unsigned> all(subject.mutants().size());
  std::iota(all.begin(), all.end(), 1U);
  subject.write_verilog(all, *o.verilog);
  return 0;
}

}  // namespace

int main_of_built(Cases (*cases)(const AnyBench&), int argc, char** argv) {
  allow_large_records();
  CLI::App app{
      "Attacks the mutants of a configuration.\n"
      "Status: 0 none survived, 1 some did, 2 could not be run."};
  Options o;
  app.add_option("SHAPE", o.shape, "Design and parameters")->required();
  app.add_option("MUTANTS", o.mutants, "At most so many")
      ->required()
      ->check(CLI::Range(1U, most_mutants));
  app.add_option("RESULTS", o.results, "Write the outcomes to this file, as JSON");
  app.add_flag("--about", o.about, "Only print two lines: of what, and how many");
  app.add_option("--verilog", o.verilog, "Only write RTL that has them to this file");
  app.add_option("--draw", o.draw, "Only draw so many that lanes kill, into the folder RESULTS");
  app.add_option("--first", o.part.first, "The first mutant; default 1")
      ->check(CLI::Range(1U, most_mutants));
  app.add_option("--count", o.part.count, "How many from there; default all")
      ->check(CLI::Range(1U, most_mutants));
  app.add_flag("--unproved", o.unproved,
               "Prove no mutant to be the same: what is not killed survives");
  app.add_option("--engines", o.engines,
                 "Which prove; default cec,cadical, which have to agree; one alone decides by "
                 "itself")
      ->type_name("A,B");
  app.add_option("--written", o.written, "Verilog of the RTL that yosys reads in its place");
  app.add_option("--prover", o.prover, "How a survivor's folder calls what proves");
  app.add_option("--failures", o.failures, "The folder of survivors");
  app.add_option("--jobs", o.threads, "Threads")->check(CLI::Range(1, 1024));
  try {
    app.parse(argc, argv);
    return run(o, cases);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const Interrupted& interrupted) {
    return 128 + interrupted.signal;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}

}  // namespace cosim::mutation
