#include "tb/cli/wave.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "model/core/input_error.h"

namespace cosim::cli {

void draw_wave(const Common& common, const AnyBench& bench, Stimulus stimulus,
               const std::string& work, const std::string& part) {
  constexpr std::size_t most_clocks = 2'000'000;
  if (!common.wave) return;
  if (stimulus.clocks.size() > most_clocks) {
    throw InputError(fmt::format("--wave: {} clocks are more than can be drawn, {}",
                                 stimulus.clocks.size(), most_clocks));
  }
  stimulus.machine = bench.title();
  stimulus.origin = work;
  std::filesystem::path file = *common.wave;
  if (!part.empty()) file.replace_extension("." + part + ".fst");
  bench.draw_wave(file.string(), stimulus, common.window());
  file.replace_extension(".gtkw");
  fmt::print("wave: {}\n", file.string());
}

}  // namespace cosim::cli
