#include "tb/cli/extent.h"

#include <fmt/core.h>

#include <cstdio>

#include "model/core/input_error.h"
#include "tb/show/plot.h"
#include "tb/util/words.h"

namespace cosim::cli {

void check_wave_clocks(const Common& common, std::uint64_t clocks) {
  if (clocks <= most_wave_clocks || !(common.wave || common.html)) return;
  throw InputError(fmt::format("{}: {} clocks are more than can be drawn, {}",
                               common.wave ? "--wave" : "--html", clocks, most_wave_clocks));
}

void check_extent(const Common& common, const Extent& extent) {
  check_wave_clocks(common, extent.clocks);
  if (common.plot) Series::check_steps(extent.steps);
}

bool leaves_terminal(const Common& common) {
  return !common.table && !common.csv.value_or("").starts_with("/dev/");
}

void announce_csv(const Common& common, const Extent& extent) {
  constexpr double giga = 1e9;
  const double size = static_cast<double>(extent.rows) * static_cast<double>(extent.row);
  if (!common.csv || size < giga) return;
  fmt::print("csv: up to {:.0f} GB, {}\n", size / giga, one_line(*common.csv));
  std::fflush(stdout);
}

std::size_t digits(std::uint64_t number) { return std::to_string(number).size(); }

}  // namespace cosim::cli
