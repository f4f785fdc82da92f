#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <sstream>
#include <thread>

#include "model/core/input_error.h"
#include "tb/support/replace_file.h"
#include "tests/mutation/campaign.h"
#include "tests/mutation/survivor.h"

namespace cosim::mutation {
namespace {

/// What a shell command prints. InputError where it fails.
std::string output_of(const std::string& command) {
  const auto close = [](std::FILE* pipe) { pclose(pipe); };
  std::unique_ptr<std::FILE, decltype(close)> pipe(popen(command.c_str(), "r"), close);
  if (!pipe) throw InputError(command + ": cannot run");
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe.get())) {
    text.append(part.data(), n);
  }
  if (pclose(pipe.release()) != 0) throw InputError(command + ": failed");
  return text;
}

/// A prover that is a program: `COMMAND VERILOG CLEAR K...` prints for each K a line "K equal"
/// where it is equal to the RTL without a mutant.
Prover program(const std::string& command, const Subject& subject) {
  return [command, &subject](const std::vector<unsigned>& mutants) {
    std::vector<bool> proved(mutants.size(), false);
    if (command.empty()) return proved;
    std::istringstream lines(output_of(fmt::format("{} '{}' {} {}", command, subject.verilog(),
                                                   subject.clear(), fmt::join(mutants, " "))));
    unsigned mutant = 0;
    for (std::string verdict; lines >> mutant >> verdict;) {
      const auto at = std::find(mutants.begin(), mutants.end(), mutant);
      if (at != mutants.end()) {
        proved[static_cast<std::size_t>(at - mutants.begin())] = verdict == "equal";
      }
    }
    return proved;
  };
}

int run(const Subject& subject, const std::string& results, const std::string& prover,
        unsigned threads, const std::string& failures) {
  Checkpoint checkpoint(results + ".part", "mutants of " + subject.bench().title());
  const Campaign campaign = run_campaign(subject, program(prover, subject), threads, checkpoint);
  replace_file(results, to_json(subject, campaign));
  checkpoint.done();
  for (std::size_t i = 0; i < campaign.outcomes.size(); ++i) {
    if (campaign.outcomes[i].end != Outcome::End::survived) continue;
    const auto kept = leave_survivor(subject, static_cast<unsigned>(i + 1), failures);
    fmt::print("survived: {}, kept in: {}\n", subject.mutants()[i], kept.string());
  }
  return campaign.count(Outcome::End::survived) == 0 ? 0 : 1;
}

}  // namespace

int main_of(const Subject& subject, int argc, char** argv) {
  CLI::App app{"Attacks the mutants of " + subject.bench().title() +
               ".\nStatus: 0 none survived, 1 some did, 2 could not be run."};
  std::string results, prover, failures = "failures";
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  app.add_option("RESULTS", results, "Write the outcomes to this file, as JSON")->required();
  app.add_option("--prover", prover, "Program that proves mutants equivalent");
  app.add_option("--failures", failures, "Where a survivor leaves its folder");
  app.add_option("--jobs", threads, "Threads")->check(CLI::Range(1, 1024));
  try {
    app.parse(argc, argv);
    return run(subject, results, prover, threads, failures);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}

}  // namespace cosim::mutation
