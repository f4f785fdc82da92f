#include "tb/sim/main_of.h"

#include <fmt/core.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>

#include "tb/dut/counts.h"
#include "tb/sim/stimulus_text.h"
#include "tb/sim/sweep.h"
#include "tb/util/parallel.h"
#include "tb/util/stack.h"
#include "tb/util/words.h"

namespace cosim::coverage {
namespace {

// What happened to the transactions of streams.
void leave_cases(const AnyBench& bench, const Result& result) {
  std::vector<Count> counts;
  for (std::size_t i = 0; i < result.happened.size(); ++i) {
    counts.push_back({bench.cases()[i], result.happened[i]});
  }
  if (!counts.empty()) leave("cases", bench.design(), counts);
}

// For who reads the file meanwhile.
Progress told_to(const std::string& file, const std::string& what) {
  return [=](std::uint64_t done, std::uint64_t cases) {
    std::ofstream(file) << fmt::format("{}: {} of {}\n", what, done, cosim::count(cases, "case"));
  };
}

int run(const AnyBench& bench, std::uint64_t seed, std::uint64_t clocks, std::uint64_t jobs,
        const std::string& progress) {
  std::vector<Sweep> sweeps{hostile_sweep(bench, seed, clocks)};
  if (!bench.job_fields().empty()) sweeps.push_back(job_sweep(bench, seed, jobs));
  for (const Sweep& sweep : sweeps) {
    const Result result = run_sweep(sweep, cores(), told_to(progress, sweep.name));
    leave_cases(bench, result);
    if (result.match()) continue;
    fmt::print("{}, {}: RTL and model differ in {}; what comes after it is not counted\n",
               bench.title(), sweep.name, result.failed);
    return 1;
  }
  return 0;
}

int replay(const std::vector<std::unique_ptr<AnyBench>>& benches, const std::string& file) {
  const Replay given = read_stimulus(file, benches);
  if (!given.bench->replay(given.stimulus).mismatch) return 0;
  fmt::print("{}, {}: RTL and model differ; what comes after it is not counted\n",
             given.bench->title(), file);
  return 1;
}

}  // namespace

int main_of(const std::vector<std::unique_ptr<AnyBench>>& benches, int argc, char** argv,
            const Counted& counted) {
  allow_large_records();
  const std::vector<std::string> words(argv, argv + argc);
  try {
    setenv("COSIM_COVERAGE", words.at(1).c_str(), 1);
    int status = 0;
    const bool replays = words.at(2) == "replay";
    if (replays) {
      for (std::size_t i = 3; i < words.size() && status == 0; ++i) {
        status = replay(benches, words[i]);
      }
    }
    for (std::size_t i = 0; !replays && i < benches.size() && status == 0; ++i) {
      status = run(*benches[i], std::stoull(words.at(2)), std::stoull(words.at(3)),
                   std::stoull(words.at(4)), words.at(1) + progress_file);
    }
    if (counted.dump != nullptr) leave_lines(counted, benches.front()->design());
    return status;
  } catch (const std::exception& error) {
    fmt::print("{}\n", error.what());
    return 2;
  }
}

}  // namespace cosim::coverage
