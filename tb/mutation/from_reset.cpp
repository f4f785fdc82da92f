#include "tb/mutation/from_reset.h"

#include <fmt/core.h>

#include "tb/bench/stimulus_text.h"
#include "tb/proof/from_reset.h"
#include "tb/report/failure.h"
#include "tb/support/output_file.h"
#include "tb/support/process.h"

namespace cosim::mutation {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

fs::path stimulus_of(const Subject& subject, unsigned mutant, const fs::path& root) {
  return root / (failure_name(subject.bench(), fmt::format("mutant {}", mutant)) + ".stim");
}

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

}  // namespace cosim::mutation
