#include "tb/rtl/netlist.h"

#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "model/core/input_error.h"
#include "tb/rtl/files.h"

namespace cosim::rtl {
namespace {

using JsonOfNetlist = nlohmann::ordered_json;

// The text of a number or, in quotation marks, of a constant 0, 1, x or z.
std::string bit_of(const JsonOfNetlist& bit) { return bit.dump(); }
bool is_constant(const std::string& bit) { return bit.starts_with('"'); }

class Netlist {
 public:
  explicit Netlist(const JsonOfNetlist& module) : module_(module) {
    for (const auto& [name, net] : module.at("netnames").items()) {
      if (net.value("hide_name", 0) != 0) continue;
      const auto& bits = net.at("bits");
      for (std::size_t i = 0; i < bits.size(); ++i) {
        names_[bit_of(bits[i])].push_back(
            {name, static_cast<long>(i), static_cast<long>(bits.size())});
      }
    }
    for (auto& [bit, names] : names_) std::ranges::stable_sort(names, {}, &NamedBit::net);
    for (const auto& cell : module.at("cells")) {
      if (type_of(cell).starts_with("$memwr")) writers_[memory_of(cell)].push_back(&cell);
      for_each_bit(cell, "input", [&](const std::string& bit) { drivers_[bit] = &cell; });
    }
    follow_outputs();
  }

  Held held() const {
    Held all;
    all.memories.assign(memories_.begin(), memories_.end());
    for (const auto& cell : module_.at("cells")) {
      const std::string& kind = kind_of(type_of(cell));
      if (kind.empty() || (kind == "latch" && is_open(cell))) continue;
      const auto q = bits_of(cell, "Q"), d = bits_of(cell, "D");
      for (std::size_t i = 0; i < q.size(); ++i) {
        // A constant that is driven besides is no place where one holds anything.
        if (is_constant(q[i]) || !live_.contains(q[i]) || !names_.contains(q[i])) continue;
        // What takes the same number on every clock, as the variable of a loop, holds nothing.
        if (type_of(cell) == "$dff" && is_constant(d[i]) && d[i] != "\"z\"") continue;
        (kind == "latch" ? all.latches : all.registers).push_back(names_.at(q[i]));
      }
    }
    return all;
  }

 private:
  static std::string type_of(const JsonOfNetlist& cell) { return cell.at("type"); }
  static std::string memory_of(const JsonOfNetlist& cell) {
    const std::string id = cell.at("parameters").value("MEMID", "");
    return id.starts_with('\\') ? id.substr(1) : id;
  }
  static std::vector<std::string> bits_of(const JsonOfNetlist& cell, const char* port) {
    std::vector<std::string> all;
    if (!cell.at("connections").contains(port)) return all;
    for (const auto& bit : cell.at("connections").at(port)) all.push_back(bit_of(bit));
    return all;
  }
  // Of all ports but those of that direction.
  template <class Visit>
  static void for_each_bit(const JsonOfNetlist& cell, const char* direction, const Visit& visit) {
    for (const auto& [port, bits] : cell.at("connections").items()) {
      if (cell.at("port_directions").at(port) == direction) continue;
      for (const auto& bit : bits) visit(bit_of(bit));
    }
  }
  // "ff", "latch" or "sr", the last of them that the type has.
  static std::string kind_of(const std::string& type) {
    std::string kind;
    std::size_t last = 0;
    for (const char* one : {"ff", "latch", "sr"}) {
      const std::size_t at = type.rfind(one);
      if (!type.starts_with('$') || at == type.npos || at < last) continue;
      kind = one;
      last = at;
    }
    return kind;
  }
  // Of a latch: at all times.
  static bool is_open(const JsonOfNetlist& cell) {
    const std::string polarity = cell.at("parameters").value("EN_POLARITY", "x");
    const auto enable = bits_of(cell, "EN");
    return !enable.empty() && enable[0] == '"' + polarity.substr(polarity.size() - 1) + '"';
  }
  void follow_outputs() {
    std::deque<std::string> left;
    for (const auto& port : module_.at("ports")) {
      if (port.at("direction") == "input") continue;
      for (const auto& bit : port.at("bits")) left.push_back(bit_of(bit));
    }
    std::set<const JsonOfNetlist*> seen;
    for (; !left.empty(); left.pop_front()) {
      const auto driver = drivers_.find(left.front());
      if (!live_.insert(left.front()).second || driver == drivers_.end()) continue;
      std::vector<const JsonOfNetlist*> cells{driver->second};
      if (type_of(*cells[0]).starts_with("$memrd")) {
        const auto writers = writers_.find(memory_of(*cells[0]));
        if (writers != writers_.end()) {
          cells.insert(cells.end(), writers->second.begin(), writers->second.end());
          memories_.insert(writers->first);
        }
      }
      for (const JsonOfNetlist* cell : cells) {
        if (!seen.insert(cell).second) continue;
        for_each_bit(*cell, "output", [&](const std::string& bit) { left.push_back(bit); });
      }
    }
  }

  const JsonOfNetlist& module_;
  std::map<std::string, std::vector<NamedBit>> names_;
  std::map<std::string, const JsonOfNetlist*> drivers_;
  std::map<std::string, std::vector<const JsonOfNetlist*>> writers_;  // of memories
  std::set<std::string> live_, memories_;
};

}  // namespace

Held read_held(const std::filesystem::path& file) {
  const auto json = JsonOfNetlist::parse(text_of(file), nullptr, false);
  if (!json.is_object()) throw InputError(file.string() + ": is no JSON of yosys");
  for (const auto& module : json.at("modules")) {
    if (module.at("attributes").contains("top")) return Netlist(module).held();
  }
  return {};
}

}  // namespace cosim::rtl
