#include "tb/program/in_lanes.h"

#include <fmt/core.h>

#include <array>

#include "model/core/input_error.h"
#include "tb/lanes/jobs.h"
#include "tb/lanes/sweep.h"
#include "tb/program/chosen.h"
#include "tb/program/registry.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

// They are made in seconds, in which one case at a time gets through some hundred million clocks:
// unless they are asked for, fewer are not worth it, and nobody knows of how many clocks jobs are.
bool are_worth_it(std::uint64_t clocks) { return clocks >= 200'000'000; }

constexpr std::array widths{512, 256, 64};

fs::path library_of(const fs::path& prepared, int lanes) {
  return prepared / fmt::format("{}.so", lanes);
}

std::unique_ptr<lanes::Built> made(const AnyBench& bench, const Sweep& sweep, bool is_hostile,
                                   int lanes) {
  const proof::BuiltMachine& machine = machine_of(bench);
  if (machine.played == nullptr || machine.streams) {
    throw InputError(fmt::format("{}: does not run in lanes: it has {}", bench.title(),
                                 model_without_formula(machine)));
  }
  const std::string folder = registry().build_folder() + "/lanes";
  if (is_hostile) {
    return lanes::built(bench.title(), machine.played(), source_of(bench), lanes, folder);
  }
  return lanes::built_for_jobs(bench, machine.played(), source_of(bench), *sweep.in_lanes, lanes,
                               folder);
}

}  // namespace

std::optional<int> lanes_asked(const std::optional<std::string>& text) {
  if (text.value_or("auto") == "auto") return {};
  for (const int lanes : {0, 64, 256, 512}) {
    if (*text == std::to_string(lanes)) return lanes;
  }
  throw InputError(
      fmt::format("--lanes: {} is none of auto, 512, 256, 64 and 0", in_quotes(*text)));
}

InLanes::InLanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t seed,
                 std::uint64_t clocks, const std::optional<std::string>& lanes)
    : sweep_(sweep) {
  const std::optional<int> asked = lanes_asked(lanes);
  const bool is_hostile = clocks != 0;
  if (asked == 0 || (!asked && !(is_hostile ? are_worth_it(clocks) : lanes.has_value()))) return;
  try {
    built_ = made(bench, sweep, is_hostile, asked.value_or(lanes::widest()));
  } catch (const InputError& error) {
    if (asked) throw;
    fmt::print("{}; one case at a time\n", error.what());
    return;
  }
  take(bench, seed, clocks);
}

InLanes::InLanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t seed,
                 std::uint64_t clocks, const fs::path& prepared)
    : sweep_(sweep) {
  for (const int lanes : widths) {
    if (lanes > lanes::widest() || !fs::exists(library_of(prepared, lanes))) continue;
    built_ = std::make_unique<lanes::Built>(library_of(prepared, lanes));
    take(bench, seed, clocks);
    return;
  }
}

void InLanes::take(const AnyBench& bench, std::uint64_t seed, std::uint64_t clocks) {
  sweep_ = clocks != 0 ? lanes::hostile_sweep(bench, *built_, seed, clocks)
                       : lanes::job_sweep(bench, *built_, sweep_);
}

void prepare_lanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t clocks, bool asked,
                   bool for_any, const fs::path& prepared) {
  if (!asked && !are_worth_it(clocks)) return;
  try {
    for (const int lanes : widths) {
      if (lanes > lanes::widest() || (lanes < lanes::widest() && !for_any)) continue;
      const fs::path library = made(bench, sweep, clocks != 0, lanes)->library;
      fs::create_directories(prepared);
      fs::copy_file(library, library_of(prepared, lanes));
    }
  } catch (const InputError& error) {
    if (asked) throw;
    fmt::print("{}; one case at a time\n", error.what());
  }
}

}  // namespace cosim::cli
