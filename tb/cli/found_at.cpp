#include "tb/cli/found_at.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "tb/cli/found_held.h"
#include "tb/proof/yosys.h"
#include "tb/support/json.h"
#include "tb/support/process.h"
#include "tb/support/quoted.h"
#include "tb/support/read_file.h"

namespace cosim::cli {
namespace {

using Bits = std::vector<int>;

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
    commands += " " + file_for_yosys(f);
  }
  const std::string which = top.empty() ? "-auto-top" : "-top " + word_for_yosys(top);
  commands += fmt::format("; hierarchy -check {}{}; proc; flatten; write_json \"{}\"", which,
                          parameters, json);
  proof::run_yosys(commands, "new");
  const Json all = json_of(read_file(json));
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
  const auto [bits, clock, reset] = held(n.module);
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
