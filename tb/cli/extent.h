// The size of a run, as far as it is known before: a run that is too long is refused at once, and a
// long one is announced.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tb/cli/common.h"

namespace cosim::cli {

/// The most clocks that --wave and --html draw.
inline constexpr std::uint64_t most_wave_clocks = 2'000'000;

struct Extent {
  std::uint64_t clocks = 0;  ///< at least, and at most a few more
  std::uint64_t steps = 0;   ///< at least; 0 if not known
  std::uint64_t rows = 0;    ///< of the CSV at most
  std::size_t row = 0;       ///< bytes of a row at most
};

/// InputError if --wave, --html or --plot cannot draw that much.
void check_extent(const Common& common, const Extent& extent);

/// InputError if a wave or a page is asked for and these are more clocks than it can show: for a
/// run whose length was not known.
void check_wave_clocks(const Common& common, std::uint64_t clocks);

/// Whether the run prints only a few lines, so that a progress bar can be shown.
bool leaves_terminal(const Common& common);

/// Prints a line if the CSV will have a gigabyte or more.
void announce_csv(const Common& common, const Extent& extent);

/// The bytes of a number in decimal.
std::size_t digits(std::uint64_t number);

}  // namespace cosim::cli
