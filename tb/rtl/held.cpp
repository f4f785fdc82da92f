#include "tb/rtl/held.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "model/core/input_error.h"
#include "tb/rtl/files.h"
#include "tb/rtl/netlist.h"

namespace cosim::rtl {
namespace {

using netlist::Cell;

// "ff", "latch" or "sr", the last of them that the type has.
std::string kind_of(const std::string& type) {
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

std::string memory_of(const Cell& cell) {
  const std::string& id = cell.parameter("MEMID");
  return id.starts_with('\\') ? id.substr(1) : id;
}

bool is_output(const Cell& cell, const std::string& pin) {
  return std::ranges::count(cell.outputs, pin) != 0;
}

// Of a latch: at all times.
bool is_open(const Cell& cell) {
  return cell.has("EN") &&
         cell.pins.at("EN")[0] == (cell.flag("EN_POLARITY") ? netlist::one : netlist::zero);
}

class Holders {
 public:
  explicit Holders(const netlist::Module& module) : module_(module) {
    for (const netlist::Net& net : module.nets) {
      if (!net.is_named) continue;
      for (std::size_t i = 0; i < net.bits.size(); ++i) {
        names_[net.bits[i]].push_back(
            {net.name, static_cast<long>(i), static_cast<long>(net.bits.size())});
      }
    }
    for (auto& [bit, names] : names_) std::ranges::stable_sort(names, {}, &NamedBit::net);
    for (const Cell& cell : module.cells) {
      if (cell.starts_with("$memwr")) writers_[memory_of(cell)].push_back(&cell);
      for (const std::string& pin : cell.outputs) {
        if (!cell.has(pin)) continue;
        for (const int bit : cell.pins.at(pin)) drivers_[bit] = &cell;
      }
    }
    follow_outputs();
  }

  Held held() const {
    Held all;
    all.memories.assign(memories_.begin(), memories_.end());
    for (const Cell& cell : module_.cells) {
      const std::string kind = kind_of(cell.type);
      if (kind.empty() || !cell.is_register() || (kind == "latch" && is_open(cell))) continue;
      const std::vector<int>& q = cell.pins.at("Q");
      for (std::size_t i = 0; i < q.size(); ++i) {
        // A constant that is driven besides is no place where one holds anything.
        if (q[i] < 0 || !live_.contains(q[i]) || !names_.contains(q[i])) continue;
        // What takes the same number on every clock, as the variable of a loop, holds nothing.
        if (cell.type == "$dff") {
          const int d = cell.pins.at("D")[i];
          if (d < 0 && d != netlist::is_z) continue;
        }
        (kind == "latch" ? all.latches : all.registers).push_back(names_.at(q[i]));
      }
    }
    return all;
  }

 private:
  void follow_outputs() {
    std::deque<int> left;
    for (const netlist::Port& port : module_.ports) {
      if (port.way != "input") left.insert(left.end(), port.bits.begin(), port.bits.end());
    }
    std::set<const Cell*> seen;
    for (; !left.empty(); left.pop_front()) {
      const auto driver = drivers_.find(left.front());
      if (!live_.insert(left.front()).second || driver == drivers_.end()) continue;
      std::vector<const Cell*> cells{driver->second};
      if (cells[0]->starts_with("$memrd")) {
        const auto writers = writers_.find(memory_of(*cells[0]));
        if (writers != writers_.end()) {
          cells.insert(cells.end(), writers->second.begin(), writers->second.end());
          memories_.insert(writers->first);
        }
      }
      for (const Cell* cell : cells) {
        if (!seen.insert(cell).second) continue;
        // Of one that yosys does not know, a pin may be both.
        for (const auto& [pin, bits] : cell->pins) {
          if (!cell->starts_with("$") || !is_output(*cell, pin)) {
            left.insert(left.end(), bits.begin(), bits.end());
          }
        }
      }
    }
  }

  const netlist::Module& module_;
  std::map<int, std::vector<NamedBit>> names_;
  std::map<int, const Cell*> drivers_;
  std::map<std::string, std::vector<const Cell*>> writers_;  // of memories
  std::set<int> live_;
  std::set<std::string> memories_;
};

}  // namespace

Held read_held(const std::filesystem::path& file) {
  try {
    return Holders(netlist::module_of(text_of(file))).held();
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

}  // namespace cosim::rtl
