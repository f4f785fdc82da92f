#include "tb/lanes/layout.h"

#include <fmt/core.h>

#include <sstream>

#include "model/core/input_error.h"

namespace cosim::lanes {

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
