// What a wave shows of a run: which signals and which clocks, and the values on one of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/core/fields.h"
#include "model/core/probe.h"

namespace cosim {

/// What a wave shows as one trace: a cell, or the words of a wide number together.
struct Bus {
  std::string name;       ///< of a cell its label, "store[3]"; of a wide number that of its field
  Field field;            ///< the cell, or the first word
  std::size_t first = 0;  ///< the number of that cell
  std::size_t count = 1;  ///< cells, the lowest bits first
  int width = 1;          ///< bits of all together
};

inline std::vector<Bus> buses_of(const std::vector<Field>& cells) {
  std::vector<Bus> all;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Field& f = cells[i];
    if (f.is_word && f.index > 0) {
      ++all.back().count;
      all.back().width += f.width;
    } else {
      all.push_back({f.is_word ? f.name : label_of(f), f, i, 1, f.width});
    }
  }
  return all;
}

/// "[7:0]" of eight bits, "" of one.
inline std::string range_of_bits(int width) {
  return width == 1 ? "" : '[' + std::to_string(width - 1) + ":0]";
}

/// An interface: its signals, which are seen together. Its last compared one is 1 where what is
/// wrong is at this interface, and is expected to be 0.
struct WavePart {
  std::string title;
  std::size_t inputs = 0, compared = 0;  ///< where those of the next one begin
};

/// What the two that are compared are called, and what they are.
struct WaveSides {
  const char* expected = "expected";
  const char* actual = "actual";
  const char* has_expected = "the model";
  const char* has_actual = "the RTL";
};

/// The signals of a machine that are drawn.
struct WaveShape {
  std::string title;
  std::vector<Field> inputs;
  std::vector<Field> compared;  ///< registers first
  std::size_t registers = 0;
  std::vector<Probe> probes;         ///< those of a scope side by side
  std::vector<WavePart> parts{};     ///< of a machine whose pins belong to interfaces; else empty
  std::vector<std::string> texts{};  ///< the names of signals that are text
  WaveSides sides{};
  std::map<std::string, std::string> ranges{};  ///< of buses by name: "[7:4]"; else "[WIDTH-1:0]"

  /// What stands behind its name, "" behind that of a single bit.
  std::string range_of(const Bus& bus) const {
    const auto own = ranges.find(bus.name);
    return own == ranges.end() ? range_of_bits(bus.width) : own->second;
  }

  /// What is wrong at an interface, which is expected nowhere.
  bool is_finding(const Bus& bus) const {
    return std::ranges::any_of(
        parts, [&](const WavePart& part) { return part.compared == bus.first + 1; });
  }
};

/// One clock of a run.
struct WaveClock {
  std::uint64_t clock = 0;
  std::vector<Word> inputs, expected, actual;
  std::vector<bool> compared;  ///< whether it means anything on this clock
  std::vector<bool> differs;   ///< of what does; both have one an entry of expected
  std::vector<Word> expected_probes, actual_probes;
  std::vector<std::string> texts;

  bool differs_in(const Bus& bus) const {
    const auto cell = differs.begin() + static_cast<std::ptrdiff_t>(bus.first);
    const auto end = cell + static_cast<std::ptrdiff_t>(bus.count);
    return std::find(cell, end, true) != end;
  }
};

/// The clocks of a run that a wave shows, and the first that differs.
struct WaveRange {
  std::uint64_t first = 0;
  std::uint64_t last = ~std::uint64_t{0};
  std::uint64_t clocks = 0;  ///< of the run as a whole
  std::optional<std::uint64_t> mismatch;
  std::string signal;  ///< the first that differs; empty where none does
};

/// Bits of the clock's number.
inline constexpr int clock_width = 40;

}  // namespace cosim
