#include "tb/sim/stimulus_text.h"

#include <fmt/core.h>

#include <algorithm>

#include "tb/util/show.h"

namespace cosim {

std::string to_text(const Stimulus& s, const AnyBench& bench) {
  std::string text = fmt::format("{}\nmachine {}\n", first_line_of_stimulus, s.machine);
  if (!s.origin.empty()) text += fmt::format("origin {}\n", s.origin);
  text += fmt::format("power-up {}\n", s.power_up);
  if (s.state) {
    constexpr std::size_t most_in_line = 100;  // a memory's may be many
    const std::vector<Field> fields = bench.state();
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (i % most_in_line == 0) text += i == 0 ? "state" : "\nstate";
      text += fmt::format(" {}={}", label_of(fields[i]), (*s.state)[i]);
    }
    text += '\n';
  }
  const std::vector<Field> inputs = bench.inputs();
  std::vector<std::size_t> widths;
  constexpr int first_width = 11;
  text += fmt::format("{:<{}}", bench.row(), first_width);
  for (const Field& f : inputs) {
    widths.push_back(std::max(label_of(f).size(), show_width(f)));
    text += fmt::format("  {:>{}}", label_of(f), widths.back());
  }
  text += '\n';
  for (std::size_t first = 0, end = 0; first < s.clocks.size(); first = end) {
    while (end < s.clocks.size() && s.clocks[end] == s.clocks[first]) ++end;
    const std::string range =
        end == first + 1 ? fmt::format("{}", first) : fmt::format("{}-{}", first, end - 1);
    text += fmt::format("{:<{}}", range, first_width);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      text += fmt::format("  {:>{}}", show_short(inputs[i], s.clocks[first][i]), widths[i]);
    }
    text += '\n';
  }
  return text + "end\n";
}

}  // namespace cosim
