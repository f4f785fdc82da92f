// What a person sees of a wave, in which order and under which names: the view for GTKWave and the
// picture on a page are both made of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tb/show/wave.h"

namespace cosim {

/// One signal.
struct WaveRow {
  enum class Kind {
    input,
    reg,
    output,
    pair,  ///< of a register or an output what is expected, and below it what is there
    probe,
  };
  Kind kind = Kind::input;
  std::size_t at = 0;  ///< the number of its bus among inputs or compared, or of its probe
  std::string shown;   ///< its name with its pin or block, of a pair without
};

struct WaveGroup {
  std::string title;    ///< empty: none
  bool is_open = true;  ///< else it repeats what the others show
  std::vector<WaveRow> rows;
};

/// The groups; `differs` is the label of the signal that differs first, or "".
std::vector<WaveGroup> wave_groups(const WaveShape& shape, const std::string& differs);

/// The first of so many clocks around the difference, or where the range begins: what is seen first
/// of a long wave.
std::uint64_t seen_first(const WaveRange& range, std::uint64_t clocks);

}  // namespace cosim
