#include <algorithm>

#include "model/core/input_error.h"
#include "tb/rtl/verilog.h"

namespace cosim::rtl {
namespace {

constexpr std::size_t nowhere = std::string::npos;

// Where the `=` of a port's default stands; npos where it has nowhere.
std::size_t default_at(const std::string& port) {
  int depth = 0;
  for (std::size_t i = 0; i < port.size(); ++i) {
    if (port[i] == '[' || port[i] == '(' || port[i] == '{') ++depth;
    if (port[i] == ']' || port[i] == ')' || port[i] == '}') --depth;
    if (port[i] == '=' && depth == 0) return i;
  }
  return nowhere;
}

// The last word before its default and its dimensions.
std::string name_of(const std::string& port, std::size_t end) {
  std::string head = trimmed(port.substr(0, end));
  while (head.ends_with(']')) head = trimmed(head.substr(0, head.rfind('[')));
  return head.substr(head.find_last_of(" \t\n]") + 1);
}

// Whether every instance gives that port a net, the one of that number in its module's list.
bool is_always_given(const Verilog& rtl, const std::string& module, const std::string& port,
                     std::size_t number) {
  for (const auto& [name, other] : rtl.modules) {
    for (const Instance& one : instances(module, other.body)) {
      const auto gives = [&](const Piece& pin) {
        return pin.text.starts_with(".*") || pin.text == '.' + port;
      };
      const auto named = joined(one.pins);
      const bool is_named = std::ranges::any_of(
          named, [&](const Joined& pin) { return pin.pin == port && !pin.net.empty(); });
      const bool is_placed = one.pins.size() > number && !one.pins[number].text.empty() &&
                             !one.pins[number].text.starts_with('.');
      if (!is_named && !is_placed && !std::ranges::any_of(one.pins, gives)) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<std::string> without_port_defaults(const std::filesystem::path& folder,
                                               const std::vector<std::string>& files,
                                               const std::filesystem::path& to) {
  Verilog rtl(folder, files);
  for (const auto& [name, module] : rtl.modules) {
    Head head;
    try {
      head = head_of(module);
    } catch (const InputError&) {
      continue;
    }
    bool is_input = false;
    for (std::size_t i = 0; i < head.items.size(); ++i) {
      const Piece& item = head.items[i];
      if (has_word(item.text, "output") || has_word(item.text, "inout")) is_input = false;
      if (has_word(item.text, "input")) is_input = true;
      const std::size_t at = is_input ? default_at(item.text) : nowhere;
      if (at == nowhere || !is_always_given(rtl, name, name_of(item.text, at), i)) continue;
      rtl.edit(module, item.at + at, item.text.size() - at, "");
    }
  }
  return rtl.write(to, false);
}

}  // namespace cosim::rtl
