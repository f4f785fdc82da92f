#include "tb/cli/found_at.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <utility>

#include "model/core/input_error.h"
#include "tb/proof/rtl.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"

namespace cosim::cli {
namespace {

using Json = nlohmann::ordered_json;
using Bits = std::vector<int>;

[[noreturn]] void refuse(const std::string& why) { throw InputError("new: " + why); }

// Bits of a net by their numbers; a constant bit is -1.
Bits bits_of(const Json& list) {
  Bits bits;
  for (const Json& bit : list) bits.push_back(bit.is_number() ? bit.get<int>() : -1);
  return bits;
}

// The top module, flat, as yosys writes it.
struct Netlist {
  std::string top;
  Json module;
};

Netlist netlist_of(const std::vector<std::string>& files, const std::string& top,
                   const std::string& parameters) {
  const Scratch scratch;
  const std::string json = (scratch.path() / "found.json").string();
  std::string commands = "read_verilog -sv";
  for (const std::string& f : files) {
    commands += " \"" + std::filesystem::absolute(f).string() + '"';
  }
  const std::string which = top.empty() ? "-auto-top" : "-top " + top;
  commands += fmt::format("; hierarchy -check {}{}; proc; flatten; write_json \"{}\"", which,
                          parameters, json);
  proof::run_yosys(commands, "new");
  const Json all = Json::parse(read_file(json));
  for (const auto& [name, module] : all.at("modules").items()) {
    const Json& attributes = module.at("attributes");
    if (!attributes.contains("top")) continue;
    // With parameters of its own it has another name, and its first one as an attribute.
    return {attributes.value("hdlname", name), module};
  }
  refuse("yosys finds no top module");
}

std::vector<FoundNet> ports(const Json& module, const std::string& direction) {
  std::vector<FoundNet> all;
  for (const auto& [name, port] : module.at("ports").items()) {
    const std::string way = port.at("direction");
    if (way == "inout") refuse(fmt::format("{}: a port of both directions", name));
    if (way == direction) all.push_back({name, {static_cast<int>(port.at("bits").size())}});
  }
  return all;
}

// The name of a bit of the module, for a person.
std::string name_of(const Json& module, int bit) {
  for (const auto& [name, net] : module.at("netnames").items()) {
    if (net.value("hide_name", 0) != 0) continue;
    const Bits bits = bits_of(net.at("bits"));
    if (std::find(bits.begin(), bits.end(), bit) != bits.end()) return name;
  }
  return "a net";
}

std::string without_backslash(const std::string& name) {
  return name.starts_with('\\') ? name.substr(1) : name;
}

// The memory that a cell writes or reads.
std::string memory_of(const Json& cell) {
  return without_backslash(cell.at("parameters").value("MEMID", ""));
}

// Whether it is a register that takes the same number on every clock, as that of a loop does.
bool holds_nothing(const Json& cell) {
  const Bits next = bits_of(cell.at("connections").at("D"));
  return std::all_of(next.begin(), next.end(), [](int bit) { return bit < 0; });
}

// The asynchronous reset, one or none: its bit.
struct Reset {
  int bit = -1;
  bool active_low = false;
};

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

// The bits that registers hold; their clock's bit, which is one, and their asynchronous reset's.
std::set<int> held(const Json& module, int& clock, Reset& reset) {
  std::set<int> bits;
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
  return bits;
}

// What the RTL has as a memory; of one that is written at constant addresses a reset is the reason.
std::vector<FoundNet> memories(const Json& module) {
  std::vector<FoundNet> all;
  if (!module.contains("memories")) return all;
  for (const auto& [name, memory] : module.at("memories").items()) {
    FoundNet net{name, {memory.at("width")}, {memory.at("size")}, false};
    for (const auto& [cell_name, cell] : module.at("cells").items()) {
      const std::string type = cell.at("type");
      if (!type.starts_with("$memwr") || memory_of(cell) != name) continue;
      const Bits address = bits_of(cell.at("connections").at("ADDR"));
      net.is_reset = net.is_reset ||
                     std::all_of(address.begin(), address.end(), [](int bit) { return bit < 0; });
    }
    all.push_back(net);
  }
  return all;
}

// Adds a register. Where yosys has made registers of a memory's words, "store[0]" and so on, it is
// one memory.
void add_net(std::vector<FoundNet>& all, const std::string& name, int width) {
  const std::size_t bracket = name.ends_with(']') ? name.rfind('[') : std::string::npos;
  if (bracket == std::string::npos) {
    all.push_back({name, {width}});
    return;
  }
  const std::string memory = name.substr(0, bracket);
  const auto same = std::find_if(all.begin(), all.end(), [&](const FoundNet& n) {
    return n.name == memory && n.words.number > 0;
  });
  if (same == all.end()) {
    all.push_back({memory, {width}, {1}});
  } else {
    ++same->words.number;
  }
}

// The nets that are those bits: of several names of the same the one nearest to the top.
std::vector<FoundNet> registers(const Json& module, std::set<int> left) {
  struct Named {
    std::string name;
    Bits bits;
  };
  std::vector<Named> nets;
  for (const auto& [name, net] : module.at("netnames").items()) {
    if (net.value("hide_name", 0) != 0) continue;
    nets.push_back({name, bits_of(net.at("bits"))});
  }
  const auto depth = [](const Named& n) { return std::count(n.name.begin(), n.name.end(), '.'); };
  const auto is_port = [&](const Named& n) { return module.at("ports").contains(n.name); };
  std::stable_sort(nets.begin(), nets.end(), [&](const Named& a, const Named& b) {
    // A port that is wired to a register is not its name, unless it has no other.
    return std::tuple(is_port(a), depth(a)) < std::tuple(is_port(b), depth(b));
  });
  std::vector<FoundNet> all;
  for (const Named& n : nets) {
    const auto is_left = [&](int bit) { return left.contains(bit); };
    if (!std::all_of(n.bits.begin(), n.bits.end(), is_left)) continue;
    for (const int bit : n.bits) left.erase(bit);
    add_net(all, n.name, static_cast<int>(n.bits.size()));
  }
  if (!left.empty()) refuse(fmt::format("{} bits of registers have no name", left.size()));
  return all;
}

std::vector<FoundParameter> defaults(const Json& module) {
  std::vector<FoundParameter> all;
  if (!module.contains("parameter_default_values")) return all;
  for (const auto& [name, value] : module.at("parameter_default_values").items()) {
    const std::string bits = value;
    const bool whole = bits.size() == 32 && bits.find_first_not_of("01") == std::string::npos;
    if (whole) all.push_back({name, static_cast<int>(std::stoul(bits, nullptr, 2))});
  }
  return all;
}

}  // namespace

Found found_at(const std::vector<std::string>& files, const std::string& top,
               const std::string& parameters, bool with_registers) {
  const Netlist n = netlist_of(files, top, parameters);
  Found found;
  found.top = n.top;
  int clock = -1;
  Reset reset;
  const std::set<int> bits = held(n.module, clock, reset);
  if (with_registers) {
    found.registers = registers(n.module, bits);
    for (const FoundNet& memory : memories(n.module)) found.registers.push_back(memory);
  }
  if (clock < 0 || (with_registers && found.registers.empty())) {
    refuse(n.top + " has no register");
  }
  for (const FoundNet& port : ports(n.module, "input")) {
    if (bits_of(n.module.at("ports").at(port.name).at("bits")) == Bits{clock}) {
      found.clock = port.name;
    } else {
      found.inputs.push_back(port);
    }
    if (reset.bit < 0 ||
        bits_of(n.module.at("ports").at(port.name).at("bits")) != Bits{reset.bit}) {
      continue;
    }
    found.reset = port.name;
    found.active_low = reset.active_low;
    found.asynchronous = true;
  }
  if (reset.bit >= 0 && !found.asynchronous) {
    refuse(fmt::format("{}: an asynchronous reset that is no input", name_of(n.module, reset.bit)));
  }
  if (found.clock.empty()) refuse(n.top + ": its clock is no input");
  found.outputs = ports(n.module, "output");
  found.parameters = defaults(n.module);
  return found;
}

}  // namespace cosim::cli
