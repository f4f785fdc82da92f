#include "tb/coverage/main_of.h"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "tb/support/parallel.h"
#include "tb/support/words.h"
#include "tb/sweep/sweep.h"

namespace cosim::coverage {
namespace {

int run(const AnyBench& bench, std::uint64_t seed, std::uint64_t clocks, std::uint64_t jobs) {
  std::vector<Sweep> sweeps{hostile_sweep(bench, seed, clocks)};
  if (!bench.job_fields().empty()) sweeps.push_back(job_sweep(bench, seed, jobs));
  for (const Sweep& sweep : sweeps) {
    const Result result = run_sweep(sweep, cores());
    if (result.match()) continue;
    fmt::print("{}, {}: RTL and model differ in {}; what comes after it is not counted\n",
               bench.title(), sweep.name, result.failed);
    return 1;
  }
  return 0;
}

}  // namespace

int main_of(const std::vector<std::unique_ptr<AnyBench>>& benches, int argc, char** argv) {
  const std::vector<std::string> words(argv, argv + argc);
  try {
    setenv("COSIM_COVERAGE", words.at(1).c_str(), 1);
    for (const auto& bench : benches) {
      const int status =
          run(*bench, std::stoull(words.at(2)), std::stoull(words.at(3)), std::stoull(words.at(4)));
      if (status != 0) return status;
    }
    return 0;
  } catch (const std::exception& error) {
    fmt::print("{}\n", error.what());
    return 2;
  }
}

}  // namespace cosim::coverage
