#include "tb/cli/found_held.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/core/input_error.h"

namespace cosim::cli {
namespace {

using Bits = std::vector<int>;

// Whether it is a register that takes the same number on every clock, as that of a loop does.
bool holds_nothing(const Json& cell) {
  const Bits next = bits_of(cell.at("connections").at("D"));
  return std::all_of(next.begin(), next.end(), [](int bit) { return bit < 0; });
}

// What drives a bit through inverters: the bit before them, and whether they invert it.
std::pair<int, bool> before_inverters(const Json& module, int bit) {
  bool odd = false;
  const auto inverter = [&] {
    for (const auto& [name, cell] : module.at("cells").items()) {
      const std::string type = cell.at("type");
      if ((type == "$not" || type == "$logic_not") &&
          bits_of(cell.at("connections").at("Y")) == Bits{bit} &&
          cell.at("connections").at("A").size() == 1) {
        bit = bits_of(cell.at("connections").at("A")).front();
        return true;
      }
    }
    return false;
  };
  while (inverter()) odd = !odd;
  return {bit, odd};
}

}  // namespace

void refuse(const std::string& why) { throw InputError("new: " + why); }

std::vector<int> bits_of(const Json& list) {
  std::vector<int> bits;
  for (const Json& bit : list) bits.push_back(bit.is_number() ? bit.get<int>() : -1);
  return bits;
}

std::string name_of(const Json& module, int bit) {
  for (const auto& [name, net] : module.at("netnames").items()) {
    if (net.value("hide_name", 0) != 0) continue;
    const Bits bits = bits_of(net.at("bits"));
    if (std::find(bits.begin(), bits.end(), bit) != bits.end()) return name;
  }
  return "a net";
}

std::string memory_of(const Json& cell) {
  const std::string name = cell.at("parameters").value("MEMID", "");
  return name.starts_with('\\') ? name.substr(1) : name;
}

Held held(const Json& module) {
  Held all;
  auto& [bits, clock, reset] = all;
  for (const auto& [name, cell] : module.at("cells").items()) {
    const std::string type = cell.at("type");
    if (type.find("latch") != std::string::npos) {
      const int bit = bits_of(cell.at("connections").at("Q")).front();
      refuse(fmt::format("{}: a latch", name_of(module, bit)));
    }
    const bool writes_memory = type.starts_with("$memwr");
    if (!type.starts_with("$") || !(writes_memory || type.find("dff") != std::string::npos)) {
      continue;
    }
    if (writes_memory &&
        std::stoi(cell.at("parameters").value("CLK_ENABLE", "1"), nullptr, 2) == 0) {
      refuse(fmt::format("{}: a memory that no clock writes", memory_of(cell)));
    }
    if (type.starts_with("$al") || type.starts_with("$dffsr")) {
      const int bit = bits_of(cell.at("connections").at("Q")).front();
      refuse(fmt::format("{}: an asynchronous set or load", name_of(module, bit)));
    }
    if (type.starts_with("$adff")) {
      const auto [by, inverted] =
          before_inverters(module, bits_of(cell.at("connections").at("ARST")).front());
      if (reset.bit >= 0 && by != reset.bit) {
        const std::string one = name_of(module, reset.bit), other = name_of(module, by);
        refuse(fmt::format("{} and {}: two asynchronous resets", std::min(one, other),
                           std::max(one, other)));
      }
      const std::string polarity = cell.at("parameters").at("ARST_POLARITY");
      reset = {by, (polarity.back() == '0') != inverted};
    }
    const int by = bits_of(cell.at("connections").at("CLK")).front();
    if (clock >= 0 && by != clock) {
      const std::string one = name_of(module, clock), other = name_of(module, by);
      refuse(fmt::format("{} and {}: two clocks", std::min(one, other), std::max(one, other)));
    }
    clock = by;
    if (writes_memory || holds_nothing(cell)) continue;
    for (const int bit : bits_of(cell.at("connections").at("Q"))) bits.insert(bit);
  }
  // What yosys puts before a memory's port.
  for (const auto& [name, net] : module.at("netnames").items()) {
    if (!name.starts_with("$memwr$")) continue;
    for (const int bit : bits_of(net.at("bits"))) bits.erase(bit);
  }
  return all;
}

}  // namespace cosim::cli
