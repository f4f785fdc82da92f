// PROGRAM mutate: small faults planted in the RTL, each of which is to be found, or to be proved to
// be none.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/cli/common.h"
#include "tb/cli/number.h"
#include "tb/cli/verdicts.h"
#include "tb/full/commands.h"
#include "tb/full/machine_of.h"
#include "tb/full/mutants_built.h"
#include "tb/full/trusted.h"
#include "tb/mutation/campaign.h"
#include "tb/sim/progress.h"
#include "tb/sim/report.h"
#include "tb/util/interrupt.h"
#include "tb/util/json.h"
#include "tb/util/json_at.h"
#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

struct MutateOptions {
  Common common;
  std::vector<std::string> words;
  Text mutants, equivalent;
  bool unproved = false, list = false;
};

void need_tools(bool unproved) {
  if (!is_installed("yosys")) throw InputError("needs yosys");
  if (!unproved && !is_installed("yosys-abc")) throw InputError("needs yosys-abc");
}

// "killed, hostile clocks, case 3, clock 17, signal count"
std::string end_of(const JsonAt& mutant) {
  const std::string end = mutant.at("end").text();
  if (end == "equivalent") return "proved equal";
  if (end == "unread") return "reaches nothing that is compared";
  if (end != "killed") return end;
  return fmt::format("killed by {}, clock {}, {}", mutant.at("stimulus").text(),
                     mutant.at("clock").whole(), mutant.at("signal").text());
}

// What the campaign with these results does now.
std::string doing_now(const std::string& results) {
  try {
    const std::string file = results + mutation::kept_as;
    return JsonAt(file, read_file(file)).at("state").at("doing").text();
  } catch (const InputError&) {
    return "begun";
  }
}

// What the campaign had done when it was stopped.
void print_stopped(const AnyBench& bench, const std::string& results) {
  try {
    const std::string file = results + mutation::kept_as;
    std::map<std::string, std::size_t> ends;
    std::size_t all = 0;
    const JsonAt kept(file, read_file(file));
    for (const JsonAt& mutant : kept.at("state").at("outcomes").list()) {
      ++ends[mutant.at("end").text()];
      ++all;
    }
    fmt::print("{}: stopped: {}: {} killed, {} proved equal, {} survived, {} not decided\n",
               bench.built_as(), count(all, "mutant"), ends["killed"], ends["equivalent"],
               ends["survived"], ends["open"]);
  } catch (const InputError&) {
    fmt::print("{}: stopped before a mutant was attacked\n", bench.built_as());
  }
}

// Mutants that a person says to be the same machine, each a line of a file:
//
//   MACHINE: MUTANT -- REASON
class Equivalent {
 public:
  explicit Equivalent(const Text& file) {
    if (!file) return;
    std::size_t number = 0;
    for (const std::string& line : lines_in(read_file(*file))) {
      ++number;
      if (line.empty() || line.starts_with('#')) continue;
      static const Pattern form("(.*[^ ]) -- *([^ ].*)");
      const auto part = form.whole(line);
      if (part.empty()) {
        throw InputError(fmt::format("{}:{}: is not MACHINE: MUTANT -- REASON", *file, number));
      }
      entries_.push_back({part[1], part[2], fmt::format("{}:{}", *file, number)});
    }
  }
  /// Takes them out of what survived, and prints each.
  void apply(const AnyBench& bench, Json& outcome) {
    std::uint64_t declared = 0;
    for (Json& mutant : outcome.at("outcomes")) {
      if (mutant.at("end") != "survived") continue;
      const std::string name = bench.built_as() + ": " + mutant.at("what").get<std::string>();
      const auto known = std::ranges::find(entries_, name, &Entry::name);
      if (known == entries_.end()) continue;
      known->is_used = true;
      mutant["end"] = "declared equivalent";
      mutant["reason"] = known->reason;
      ++declared;
      fmt::print("declared equivalent: {}: {}\n", name, known->reason);
    }
    if (declared == 0) return;
    // After the loop: a new key moves the values of the object.
    outcome["survived"] = outcome["survived"].get<std::uint64_t>() - declared;
    outcome["declared"] = declared;
  }
  /// Says which lines are of no survivor of these machines.
  void complain_of_unused(const std::vector<const AnyBench*>& machines) const {
    for (const Entry& one : entries_) {
      const auto is_of = [&](const AnyBench* bench) {
        return one.name.starts_with(bench->built_as() + ": ");
      };
      if (one.is_used || std::ranges::none_of(machines, is_of)) continue;
      complain(fmt::format("{}: no such mutant survives: {}", one.place, one.name));
    }
  }

 private:
  struct Entry {
    std::string name, reason, place;
    bool is_used = false;
  };
  std::vector<Entry> entries_;
};

// Plants, attacks and prints; the results.
Json attacked(const MutateOptions& o, const Registry& registry, const AnyBench& bench,
              std::uint64_t mutants) {
  const std::string program = built_mutants(registry, bench, mutants);
  const Scratch scratch;
  const std::string results = (scratch.path() / "results.json").string();
  const proof::BuiltMachine& machine = machine_of(bench);
  const bool unproved = !machine.is_provable();
  if (unproved) {
    fmt::print("{}: {}: no mutant can be proved equal\n", bench.built_as(), kind_of_model(machine));
  }
  if (!unproved) {
    const nets::Model model = machine.nets();
    require_read(model, source_for(model, source_of(bench)));
  }
  std::vector<std::string> words{results, "--prover", program_name() + " prove", "--failures",
                                 o.common.failures_folder()};
  if (o.unproved || unproved) words.emplace_back("--unproved");
  const Ended ended = [&] {
    StateLine line;
    line.show([&] { return bench.built_as() + ": " + doing_now(results); });
    try {
      return run_mutants(program, words);
    } catch (const Interrupted&) {
      print_stopped(bench, results);
      throw;
    }
  }();
  const JsonAt outcome(results, read_file(results));
  const std::uint64_t unread = outcome.at("unread").whole();
  fmt::print("{}: {}: {} killed, {} proved equal, {} survived{}\n", bench.built_as(),
             count(outcome.at("mutants").whole(), "mutant"), outcome.at("killed").whole(),
             outcome.at("equivalent").whole(), outcome.at("survived").whole(),
             unread == 0 ? "" : fmt::format(", {} can reach nothing that is compared", unread));
  if (o.list) {
    for (const JsonAt& mutant : outcome.at("outcomes").list()) {
      fmt::print("  {}: {}: {}\n", mutant.at("mutant").whole(), mutant.at("what").text(),
                 end_of(mutant));
    }
  }
  fmt::print("{}", ended.text);
  return outcome.json();
}

// Of a shape: each survivor is a line of its failure.
ci::Verdict verdict_of(const AnyBench& bench, const JsonAt& outcome) {
  const std::uint64_t survived = outcome.at("survived").whole();
  ci::Verdict one{bench.built_as(), ci::Verdict::End::passed, "survived", ""};
  if (survived != 0) one.end = ci::Verdict::End::failure;
  one.text =
      fmt::format("{} of {} survived\n", survived, count(outcome.at("mutants").whole(), "mutant"));
  for (const JsonAt& mutant : outcome.at("outcomes").list()) {
    if (mutant.at("end").text() != "survived") continue;
    one.text += fmt::format("{}: {}\n", mutant.at("mutant").whole(), mutant.at("what").text());
  }
  return one;
}

int run(const MutateOptions& o, const Registry& registry, Verdicts& verdicts) {
  const InterruptGuard interrupts;
  constexpr std::uint64_t most = 65535;  // what chooses one has 16 bits
  const std::uint64_t mutants = whole("--mutants", o.mutants.value_or("100"), 1, most);
  const auto benches = chosen_shapes(o.words);
  need_tools(o.unproved);
  Json all = Json::array();
  Equivalent equivalent(o.equivalent);
  bool survived = false;
  for (const AnyBench* bench : benches) {
    all.push_back(attacked(o, registry, *bench, mutants));
    equivalent.apply(*bench, all.back());
    survived = survived || all.back().at("survived") != 0;
    verdicts.add(verdict_of(*bench, JsonAt::of("results", all.back())));
  }
  equivalent.complain_of_unused(benches);
  write_report(o.common.report.value_or(""), json_text(all, 1) + '\n');
  return survived ? 1 : 0;
}

}  // namespace

void add_mutate(const Command& program, const Registry& registry) {
  if (!registry.has_designs()) return;
  auto o = std::make_shared<MutateOptions>();
  const Command command = program.sub(mutate_command.name, mutate_command.help);
  command.arguments("MACHINE", o->words, "A design, or a line of 'list'; default all");
  command.text("--mutants", o->mutants, "N",
               "At most N for each configuration, 1 to 65535; default 100");
  command.flag("--unproved", o->unproved, "Do without proofs: what is not found survives");
  command.text("--equivalent", o->equivalent, "FILE",
               "Survivors known to be equal, a line each: MACHINE: MUTANT -- REASON");
  command.flag("--list", o->list, "Print each mutant and what became of it");
  command.text("--failures", o->common.failures, "DIR",
               "The folder of survivors; default $COSIM_FAILURES or failures");
  command.text("--report", o->common.report, "FILE", "Write what became of each as JSON");
  add_junit(command, o->common);
  command.footer(
      fmt::format("Needs yosys, which plants them, and a compiler.\n"
                  "An engine looks for a stimulus from reset for each mutant that is left, and "
                  "keeps it in DIR.\n"
                  "Exit status: 0 none survived, 1 some did, 2 bad input.\n"
                  "Example: {} mutate {} --mutants 20",
                  program_name(), benches().front()->built_as()));
  command.action([o, &registry] {
    return with_verdicts(mutate_command.name, mutate_command.name, o->common,
                         [&](Verdicts& verdicts) { return run(*o, registry, verdicts); });
  });
}

}  // namespace cosim::cli
