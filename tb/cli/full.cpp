#include "tb/cli/full.h"

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

// Lanes are made in seconds, in which one case at a time gets through some hundred million clocks:
// unless they are asked for, fewer are not worth it, and nobody knows of how many clocks jobs are.
bool are_worth_it(std::uint64_t clocks) { return clocks >= 200'000'000; }

}  // namespace

std::optional<int> lanes_asked(const Text& lanes) {
  if (lanes.value_or("auto") == "auto") return {};
  if (*lanes == "gpu") return on_gpu;
  for (const int number : {0, 64, 256, 512}) {
    if (*lanes == std::to_string(number)) return number;
  }
  throw InputError(
      fmt::format("--lanes: {} is not auto, gpu, 512, 256, 64 or 0", in_quotes(*lanes)));
}

bool is_for_lanes(std::uint64_t clocks, const Text& lanes) {
  const std::optional<int> asked = lanes_asked(lanes);
  if (asked) return *asked != 0;
  return clocks != 0 ? are_worth_it(clocks) : lanes.has_value();
}

}  // namespace cosim::cli
