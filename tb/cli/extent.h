// How much a run is, where that is known before it: what cannot be drawn is refused then, and who
// waits is told for what.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tb/cli/common.h"

namespace cosim::cli {

/// The most clocks that --wave draws.
inline constexpr std::uint64_t most_wave_clocks = 2'000'000;

struct Extent {
  std::uint64_t clocks = 0;  ///< it takes as many, or a few more
  std::uint64_t steps = 0;   ///< it makes as many, or more; 0 where that is not known
  std::uint64_t rows = 0;    ///< of its CSV at the most
  std::size_t row = 0;       ///< bytes of such a row at the most
};

/// InputError where --wave or --plot cannot draw so much.
void check_extent(const Common& common, const Extent& extent);

/// InputError of a wave of so many clocks, where it is known only now that they are too many.
void check_wave_clocks(std::uint64_t clocks);

/// Whether nothing but a few lines goes to the terminal meanwhile.
bool leaves_terminal(const Common& common);

/// A line of its own on a CSV of a gigabyte or more.
void announce_csv(const Common& common, const Extent& extent);

/// The bytes of a number in decimal.
std::size_t digits(std::uint64_t number);

}  // namespace cosim::cli
