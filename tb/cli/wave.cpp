#include "tb/cli/wave.h"

#include <fmt/core.h>

#include <filesystem>

#include "tb/cli/extent.h"
#include "tb/show/view.h"

namespace cosim::cli {

std::string wave_file(const std::string& file, const std::string& part) {
  std::filesystem::path path = file;
  if (!part.empty()) path.replace_extension("." + part + ".fst");
  return path.string();
}

Looks draw_wave(const Common& common, const AnyBench& bench, Stimulus stimulus,
                const std::string& work, const std::string& part) {
  if (!common.wave && !common.html) return {};
  check_wave_clocks(common, stimulus.clocks.size());
  stimulus.machine = bench.title();
  stimulus.origin = work;
  const std::string file = common.wave ? wave_file(*common.wave, part) : "";
  Looks looks{{part.empty() ? "The wave" : "The wave of " + stimulus.machine}};
  looks.back().picture = bench.draw_wave(file, stimulus, common.window());
  if (common.wave) fmt::print("wave: {}\n", view_file(file));
  return common.html ? looks : Looks{};
}

}  // namespace cosim::cli
