#include "tb/lanes/layout.h"

#include <fmt/core.h>

#include <sstream>

#include "model/core/input_error.h"

namespace cosim::lanes {

void put_registers(const Layout& layout, std::uint64_t* planes, std::size_t words, std::size_t lane,
                   const std::vector<Word>& codes) {
  for (std::size_t r = 0; r < layout.registers.size(); ++r) {
    for (std::size_t b = 0; b < layout.registers[r].size(); ++b) {
      const std::size_t plane = layout.registers[r][b];
      if (plane == Layout::none) continue;
      std::uint64_t& word = planes[plane * words + lane / 64];
      const std::uint64_t own = std::uint64_t{1} << (lane % 64);
      word = bit(codes.at(r), static_cast<int>(b)) ? word | own : word & ~own;
    }
  }
}

std::string to_text(const Layout& layout) {
  std::string text;
  for (const Layout::First first : layout.planes) text += static_cast<char>(first);
  text += fmt::format(" {} {} {}", layout.state, layout.counters, layout.registers.size());
  for (const auto& planes : layout.registers) {
    text += fmt::format(" {}", planes.size());
    for (const std::size_t plane : planes) text += fmt::format(" {}", plane);
  }
  return text;
}

Layout parse_layout(const std::string& text) {
  std::istringstream words(text);
  Layout layout;
  std::string planes;
  std::size_t registers = 0;
  words >> planes >> layout.state >> layout.counters >> registers;
  for (const char c : planes) layout.planes.push_back(static_cast<Layout::First>(c));
  for (std::size_t i = 0; words && i < registers; ++i) {
    std::size_t width = 0;
    words >> width;
    auto& held = layout.registers.emplace_back();
    for (std::size_t b = 0; words && b < width; ++b) words >> held.emplace_back();
  }
  if (!words) throw InputError("lanes: no layout");
  return layout;
}

}  // namespace cosim::lanes
