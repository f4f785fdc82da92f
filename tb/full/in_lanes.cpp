#include "tb/full/in_lanes.h"

#include <fmt/core.h>

#include <array>
#include <memory>
#include <utility>

#include "model/core/input_error.h"
#include "tb/cli/full.h"
#include "tb/cli/registry.h"
#include "tb/full/machine_of.h"
#include "tb/full/trusted.h"
#include "tb/lanes/jobs.h"
#include "tb/lanes/sweep.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array widths{512, 256, 64};

// The streams of a design whose step runs in lanes.
bool is_beside_a_step(const AnyBench& bench) { return !bench.view().empty(); }

fs::path library_of(const fs::path& prepared, int lanes) {
  return prepared / fmt::format("{}.so", lanes);
}

// What lanes are made of: make(title, played, source, folder).
template <class Make>
auto made_by(const AnyBench& bench, const Sweep& sweep, bool is_hostile, Make make) {
  proof::BuiltMachine machine = machine_of(bench);
  machine.streams |= is_beside_a_step(bench);
  if (machine.played == nullptr || machine.streams) {
    throw InputError(
        fmt::format("{}: does not run in lanes: it has {}", bench.title(), kind_of_model(machine)));
  }
  const std::string folder = registry().build_folder() + "/lanes";
  nets::Played played = machine.played();
  if (!is_hostile) {
    if (machine.jobs == nullptr || !sweep.in_lanes) {
      throw InputError(
          fmt::format("{}: its jobs do not run in lanes: they are driven on machine integers alone",
                      bench.title()));
    }
    played.draw = machine.jobs();
  }
  const proof::Source source = source_of(bench);
  require_read(played.model, read_for(played.model.machine, source));
  return make(bench.title(), played, source, folder);
}

std::unique_ptr<lanes::Built> made(const AnyBench& bench, const Sweep& sweep, bool is_hostile,
                                   int lanes) {
  return made_by(
      bench, sweep, is_hostile,
      [&](const auto& title, const auto& played, const auto& source, const auto& folder) {
        return lanes::built(title, played, source, lanes, folder);
      });
}

Sweep taken(const AnyBench& bench, const Sweep& sweep, std::uint64_t seed, std::uint64_t clocks,
            std::shared_ptr<lanes::Built> built) {
  Sweep all = clocks != 0 ? lanes::hostile_sweep(bench, *built, seed, clocks)
                          : lanes::job_sweep(bench, *built, sweep);
  // As long as somebody can run it.
  all.run_some = [run = all.run_some, built = std::move(built)](
                     std::uint64_t first, std::uint64_t count) { return run(first, count); };
  return all;
}

}  // namespace

Sweep in_lanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t seed, std::uint64_t clocks,
               const Text& lanes) {
  const std::optional<int> asked = lanes_asked(lanes);
  if (asked == on_gpu && clocks == 0) {
    throw InputError("--lanes gpu: for --hostile alone; jobs run in 512, 256 or 64 lanes");
  }
  if (asked == on_gpu)
    return lanes::hostile_sweep(bench, made_by(bench, sweep, true, lanes::on_gpu), seed, clocks);
  std::shared_ptr<lanes::Built> built;
  try {
    built = made(bench, sweep, clocks != 0, asked.value_or(lanes::widest()));
  } catch (const InputError& error) {
    if (asked && !is_beside_a_step(bench)) throw;
    fmt::print("{}; one case at a time\n", error.what());
    return sweep;
  }
  return taken(bench, sweep, seed, clocks, std::move(built));
}

Sweep in_prepared_lanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t seed,
                        std::uint64_t clocks, const fs::path& prepared) {
  for (const int lanes : widths) {
    if (lanes > lanes::widest() || !fs::exists(library_of(prepared, lanes))) continue;
    return taken(bench, sweep, seed, clocks,
                 std::make_shared<lanes::Built>(library_of(prepared, lanes)));
  }
  return sweep;
}

void prepare_lanes(const AnyBench& bench, const Sweep& sweep, std::uint64_t clocks, bool asked,
                   bool for_any, const fs::path& prepared) {
  if (!asked && (clocks == 0 || !is_for_lanes(clocks, {}))) return;
  try {
    for (const int lanes : widths) {
      if (lanes > lanes::widest() || (lanes < lanes::widest() && !for_any)) continue;
      const fs::path library = made(bench, sweep, clocks != 0, lanes)->library;
      fs::create_directories(prepared);
      fs::copy_file(library, library_of(prepared, lanes));
    }
  } catch (const InputError& error) {
    if (asked && !is_beside_a_step(bench)) throw;
    fmt::print("{}; one case at a time\n", error.what());
  }
}

}  // namespace cosim::cli
