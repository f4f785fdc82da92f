#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "model/core/input_error.h"
#include "tb/mutation/campaign.h"
#include "tb/mutation/survivor.h"
#include "tb/proof/machines.h"
#include "tb/proof/mutants.h"
#include "tb/support/parallel.h"
#include "tb/support/replace_file.h"

namespace cosim::mutation {
namespace {

constexpr int kLimit = 60;  // seconds of a solver for one mutant

Prover nobody();

/// The solvers, on the formulas of the subject's model.
Prover solvers(const Subject& subject) {
  for (const auto& machine : proof::built_machines()) {
    if (machine.title != subject.bench().title()) continue;
    if (machine.formula == nullptr) return nobody();  // a plain model
    return [&subject, formula = machine.formula()](const std::vector<unsigned>& mutants) {
      std::vector<bool> proved;
      for (const auto& judged :
           proof::judge_mutants(formula, subject.verilog(), mutants, kLimit, 1)) {
        proved.push_back(judged.same);
      }
      return proved;
    };
  }
  throw InputError(subject.bench().title() + ": is no machine that is built");
}

Prover nobody() {
  return
      [](const std::vector<unsigned>& mutants) { return std::vector<bool>(mutants.size(), false); };
}

int run(const Subject& subject, const std::string& prover, const std::string& results, bool prove,
        unsigned threads, const std::string& failures) {
  Checkpoint checkpoint(results + ".part", "mutants of " + subject.bench().title());
  const Campaign campaign =
      run_campaign(subject, prove ? solvers(subject) : nobody(), threads, checkpoint);
  replace_file(results, to_json(subject, campaign));
  checkpoint.done();
  for (std::size_t i = 0; i < campaign.outcomes.size(); ++i) {
    if (campaign.outcomes[i].end != Outcome::End::survived) continue;
    const auto kept = leave_survivor(subject, static_cast<unsigned>(i + 1), prover, failures);
    fmt::print("survived: {}, kept in: {}\n", subject.mutants()[i], kept.string());
  }
  return campaign.count(Outcome::End::survived) == 0 ? 0 : 1;
}

}  // namespace

int main_of(const Subject& subject, const std::string& prove, int argc, char** argv) {
  CLI::App app{"Attacks the mutants of " + subject.bench().title() +
               ".\nStatus: 0 none survived, 1 some did, 2 could not be run."};
  std::string results, failures = "failures";
  bool unproved = false;
  unsigned threads = cosim::cores();
  app.add_option("RESULTS", results, "Write the outcomes to this file, as JSON")->required();
  app.add_flag("--unproved", unproved,
               "Prove no mutant to be the same: what is not killed survives");
  app.add_option("--failures", failures, "Where a survivor leaves its folder");
  app.add_option("--jobs", threads, "Threads")->check(CLI::Range(1, 1024));
  try {
    app.parse(argc, argv);
    return run(subject, prove, results, !unproved, threads, failures);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}

}  // namespace cosim::mutation
