#include "tb/equiv/side.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "model/core/input_error.h"
#include "tb/equiv/front_end.h"
#include "tb/equiv/sources.h"
#include "tb/nets/cells.h"
#include "tb/util/pattern.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;

// Whether it is part of what a memory is, and is the same in one that can take its place. How it is
// written is told by what comes of it, and a mask that is empty has as many bits as there are
// ports.
bool is_of_shape(const std::string& name, const std::string& value) {
  if (name == "WR_WIDE_CONTINUATION" || name == "RD_TRANSPARENCY_MASK" ||
      name == "RD_COLLISION_X_MASK") {
    return value.find('1') != std::string::npos;
  }
  return name != "MEMID" && !name.starts_with("WR_");
}

// Whether a net goes anywhere else than to the clocks of registers and memories.
bool is_read(const Module& module, int net) {
  const auto has = [&](const std::vector<int>& bits) {
    return std::find(bits.begin(), bits.end(), net) != bits.end();
  };
  for (const Port& port : module.ports) {
    if (port.way != "input" && has(port.bits)) return true;
  }
  static const std::set<std::string> clocks{"CLK", "WR_CLK", "RD_CLK"};
  for (const Cell& cell : module.cells) {
    for (const auto& [pin, bits] : cell.pins) {
      if (!clocks.contains(pin) && has(bits)) return true;
    }
  }
  return false;
}

// ": g", a name that a net has.
std::string name_behind(const Module& module, int bit) {
  for (const Net& net : module.nets) {
    if (net.is_named && std::ranges::find(net.bits, bit) != net.bits.end()) return ": " + net.name;
  }
  return "";
}

// The names of the net that a register drives, and where it stands in the source.
std::string register_text(const Module& module, const Cell& cell) {
  const int bit = cell.pins.at("Q").front();
  std::string text;
  for (const Net& net : module.nets) {
    if (net.is_named && std::ranges::find(net.bits, bit) != net.bits.end()) text = net.name;
  }
  text = text.empty() ? "a register" : "register " + text;
  const std::string place = cell.source.substr(cell.source.rfind('/') + 1);
  return place.empty() ? text : fmt::format("{} ({})", text, place);
}

}  // namespace

const char* name_of(FrontEnd front_end) { return front_end == FrontEnd::yosys ? "yosys" : "slang"; }

Side::Side(const Files& files, std::string what, FrontEnd front_end, const Budget& budget)
    : files_(files), what_(std::move(what)), front_end_(front_end) {
  static const Pattern name(R"([A-Za-z_][\w$]*)");
  if (name.whole(files.top).empty()) {
    throw InputError(fmt::format("--top: {} is no name of Verilog", in_quotes(files.top)));
  }
  for (const fs::path& file : files.files) read_file(file.string());
  for (const fs::path& folder : files.include_dirs) {
    if (!fs::is_directory(folder)) {
      throw InputError(fmt::format("--include: {} is no folder", in_quotes(folder.string())));
    }
  }
  const std::vector<SourceText> sources = sources_of(files_);
  has_zeros_by_type_ = front_end == FrontEnd::slang && has_types_of_two_values(sources);
  const Elaborated text = elaborated(files_, what_, front_end_, budget);
  has_unique_ = text.has_unique;
  Module module = netlist::module_of(text.json);
  nets::connect_clocks(module);
  module_ = std::make_shared<const Module>(std::move(module));
  form_ = netlist::form_of(text.rtlil);
  ports();
  static const std::string x = "'[sS]?[bBoOhHdD]?[0-9a-fA-F_]*[xX]";
  // An x that is written nowhere is what a function returns where it assigns nothing.
  const std::string kept = kept_by_function();
  if (kept.starts_with("variable result ") && place_of(sources, x).empty()) {
    throw Refused(fmt::format("{}: {}", what_, kept));
  }
}

// What is read of a variable of a function where no call has written it is a register, or an x that
// a multiplexer chooses.
std::string Side::kept_by_function() const {
  for (const Cell& cell : module_->cells) {
    const auto is_open = [&](const char* pin) {
      return cell.has(pin) && std::ranges::find(cell.pins.at(pin), is_x) != cell.pins.at(pin).end();
    };
    if (!cell.has("Y") || !cell.has("S") || (!is_open("A") && !is_open("B"))) continue;
    if (const std::string kept = kept_by_function(cell); !kept.empty()) return kept;
  }
  return "";
}

std::string Side::kept_by_function(const Cell& cell) const {
  static const Pattern local(R"(([A-Za-z_]\w*)\$func\$.*\$\d+\.\$?([A-Za-z_]\w*)(\[.*)?)");
  const std::vector<int>& out = cell.pins.at(cell.has("Q") ? "Q" : "Y");
  for (const Net& net : module_->nets) {
    if (std::ranges::find(net.bits, out.front()) == net.bits.end()) continue;
    for (const Pattern::Parts& part : local.all(net.name)) {
      const bool is_automatic =
          !place_of(sources_of(files_), "\\bfunction\\s+automatic\\b[^;(]*\\b" + part[1] + "\\b")
               .empty();
      if (is_automatic) continue;
      return fmt::format("variable {} of function {} may keep its value from call to call", part[2],
                         part[1]);
    }
  }
  return "";
}

Side read(const Files& files, const std::string& what, const Budget& budget) {
  if (has_slang() && has_types_of_two_values(sources_of(files))) {
    try {
      return {files, what, FrontEnd::slang, budget};
    } catch (const Refused&) {
      throw;
    } catch (const InputError&) {  // yosys may read it
    }
  }
  try {
    return {files, what, FrontEnd::yosys, budget};
  } catch (const Refused&) {
    throw;
  } catch (const InputError& error) {
    const bool is_sv = std::ranges::any_of(
        files.files, [](const auto& file) { return file.extension() == ".sv"; });
    if (!has_slang()) throw InputError(error.what() + (is_sv ? slang_hint() : ""));
    try {
      return {files, what, FrontEnd::slang, budget};
    } catch (const InputError& by_slang) {
      throw InputError(is_sv ? by_slang.what() : error.what());
    }
  }
}

void Side::takes_over(const std::string& by, bool falls) {
  if (clocks.try_emplace(by, falls).first->second != falls) {
    throw InputError(fmt::format("{}: both edges of {} are used", what_, by));
  }
}

void Side::ports() {
  std::map<int, std::string> port_of;
  for (const Port& port : module_->ports) {
    if (port.way == "inout")
      throw InputError(fmt::format("{}: port {} is inout", what_, port.name));
    (port.way == "input" ? inputs : outputs)[port.name] = static_cast<int>(port.bits.size());
    declared[port.name] = port.declared;
    if (port.way == "input" && port.bits.size() == 1) port_of[port.bits.front()] = port.name;
  }
  const auto clocked = [&](const Cell& cell, int bit, bool falls) {
    const auto at = port_of.find(bit);
    if (at == port_of.end()) {
      throw InputError(
          fmt::format("{}: {} has a clock that is no input{}", what_,
                      cell.is_memory() ? "memory " + cell.name : register_text(*module_, cell),
                      name_behind(*module_, bit)));
    }
    takes_over(at->second, falls);
  };
  for (const Cell& cell : module_->cells) {
    if (cell.is_memory()) {
      const std::vector<int>& write_clocks = cell.pins.at("WR_CLK");
      const unsigned writes = cell.number("WR_PORTS"), reads = cell.number("RD_PORTS");
      for (unsigned i = 0; i < writes; ++i) {
        const auto is_set = [&](const char* name) {
          const std::string& bits = cell.parameter(name);
          return i < bits.size() && bits[bits.size() - 1 - i] == '1';
        };
        if (!is_set("WR_CLK_ENABLE")) throw InputError(what_ + ": a memory that no clock writes");
        clocked(cell, write_clocks.at(i), !is_set("WR_CLK_POLARITY"));
        if (write_clocks.at(i) != write_clocks.front()) {
          throw InputError(what_ + ": a memory that two clocks write");
        }
      }
      if (cell.parameter("RD_CLK_ENABLE").find('1') != std::string::npos ||
          cell.parameter("WR_WIDE_CONTINUATION").find('1') != std::string::npos) {
        throw InputError(
            fmt::format("{}: memory {} has ports of an unknown kind", what_, cell.name));
      }
      std::string shape;
      for (const auto& [name, text] : cell.parameters) {
        if (is_of_shape(name, text)) shape += name + ' ' + text + ' ';
      }
      memories.push_back({cell.name, shape, cell.parameter("INIT").find('x') != std::string::npos,
                          static_cast<int>(cell.number("WIDTH")),
                          static_cast<int>(cell.number("ABITS")), static_cast<int>(reads),
                          static_cast<int>(writes),
                          writes > 0 ? port_of.at(write_clocks.front()) : ""});
    } else if (cell.is_register()) {
      // An asynchronous load of a constant is a reset.
      if (cell.type.find("latch") != std::string::npos || cell.type == "$sr") {
        throw InputError(fmt::format("{}: {} is a latch", what_, register_text(*module_, cell)));
      }
      if (const std::string kept = kept_by_function(cell); !kept.empty()) {
        throw Refused(fmt::format("{}: {}", what_, kept));
      }
      if (cell.starts_with("$_")) {
        throw InputError(fmt::format("{}: an unknown cell: {}", what_, cell.type));
      }
      if (cell.has("CLK")) clocked(cell, cell.pins.at("CLK").front(), !cell.flag("CLK_POLARITY"));
      for (const char* pin : {"ARST", "ALOAD", "SET", "CLR"}) {
        if (!cell.has(pin)) continue;
        const auto at = port_of.find(cell.pins.at(pin).front());
        const std::string by = at == port_of.end() ? "a signal" : at->second;
        const bool is_load =
            cell.has("ALOAD") &&
            std::ranges::any_of(cell.pins.at("AD"), [](int bit) { return bit >= 0; });
        if (is_load || cell.has("SET") || cell.has("CLR")) {
          throw Refused(fmt::format(
              "{}: {}: {}", what_, register_text(*module_, cell),
              is_load
                  ? fmt::format("{} loads a value that is not constant, asynchronously", by)
                  : fmt::format("it has an asynchronous set and an asynchronous reset, {}", by)));
        }
        if (at != port_of.end()) {
          asynchronous_resets[by] = cell.flag(std::string(pin) + "_POLARITY");
        }
      }
    }
  }
  for (const Port& port : module_->ports) {
    if (clocks.contains(port.name) && is_read(*module_, port.bits.front())) {
      clocks_as_data.insert(port.name);
    }
  }
}

}  // namespace cosim::equiv
