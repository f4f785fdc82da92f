// Finds the nets of a Verilated class by name, and compares its ports with a design's tables.
#include <fmt/core.h>
#include <verilated_syms.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

#include "model/core/input_error.h"
#include "tb/dut/named_adapter.h"
#include "tb/support/place.h"

namespace cosim {
namespace {

// "TOP.top.g[1].part" of "TOP.top.g__BRA__1__KET__.part"; newer versions of Verilator may write it
// so.
std::string plain(std::string path) {
  for (const auto& [coded, bracket] : {std::pair{"__BRA__", "["}, std::pair{"__KET__", "]"}}) {
    for (std::size_t at; (at = path.find(coded)) != std::string::npos;) {
      path.replace(at, std::strlen(coded), bracket);
    }
  }
  return path;
}

const VerilatedScope* scope_of(VerilatedContext& context, const std::string& path) {
  for (const auto& [name, scope] : *context.scopeNameMap()) {
    if (plain(name) == path) return scope;
  }
  return nullptr;
}

RtlNet found_net(const VerilatedVar& var) {
  const int width = var.dims() == var.udims() ? 1 : var.packed().elements();
  return {width, var.udims() == 0 ? 0 : var.unpacked().elements()};
}

// Words of a memory lie one behind the other, in the order of their numbers.
Net net_at(const VerilatedVar& var, const Place& place, int width) {
  const auto each = static_cast<int>(var.entSize());
  auto* data = static_cast<unsigned char*>(var.datap()) + std::max(place.word, 0) * each;
  const bool whole = place.low == 0 && width == found_net(var).width && each <= 8;
  return {data, whole ? each : 0, place.low, width};
}

[[noreturn]] void refuse(const std::string& title, const std::string& why) {
  throw InputError(title + ": " + why);
}

// The path of the top module. Beside it stands the class's own scope, which has the pins.
constexpr const char* pins = "TOP.TOP";
std::string top_of(VerilatedContext& context) {
  for (const auto& [path, scope] : *context.scopeNameMap()) {
    const std::string name = path;
    if (name != pins && name.starts_with("TOP.") && name.find('.', 4) == std::string::npos) {
      return name;
    }
  }
  return "TOP";
}

const VerilatedVar* var_in(const VerilatedScope* scope, const std::string& name) {
  if (scope == nullptr || scope->varsp() == nullptr) return nullptr;
  const auto found = scope->varsp()->find(name.c_str());
  return found == scope->varsp()->end() ? nullptr : &found->second;
}

// A register: a net or a memory, or in RTL that a tool has written a net for each word of a memory.
std::vector<const VerilatedVar*> vars_of(const VerilatedScope* scope, const std::string& name) {
  if (const VerilatedVar* whole = var_in(scope, name)) return {whole};
  std::vector<const VerilatedVar*> words;
  while (const VerilatedVar* word = var_in(scope, fmt::format("{}[{}]", name, words.size()))) {
    words.push_back(word);
  }
  return words;
}

// Whether the top module has a net of that name, dots and all: RTL that was flattened.
bool is_flat(VerilatedContext& context, const std::string& net) {
  return !vars_of(scope_of(context, top_of(context)), net).empty();
}

// How many cells behind `row` the shape does not have.
std::size_t absent_after(std::span<const Field> cells, std::span<const Field> row) {
  const auto rest = cells.subspan(static_cast<std::size_t>(row.data() - cells.data()) + row.size());
  return static_cast<std::size_t>(
      std::find_if(rest.begin(), rest.end(), [](const Field& f) { return f.width != 0; }) -
      rest.begin());
}

// What a report calls the net of a field.
std::string named(const char* what, const Field& field) {
  return fmt::format("{} {}", what, field.net);
}

}  // namespace

// At most nine bytes hold the bits of a cell.
Word Net::get_bits() const {
  const auto* from = static_cast<const unsigned char*>(data);
  const int first = low / 8, last = (low + width - 1) / 8;
  std::uint64_t value = 0;
  std::memcpy(&value, from + first, static_cast<std::size_t>(std::min(last - first + 1, 8)));
  value >>= low % 8;
  if (last - first == 8) value |= static_cast<std::uint64_t>(from[last]) << (64 - low % 8);
  return low_bits(static_cast<Word>(value), width);
}

void Net::set_bits(Word value) const {
  auto* to = static_cast<unsigned char*>(data);
  for (int done = 0; done < width;) {
    const int at = low + done, bit = at % 8, count = std::min(8 - bit, width - done);
    const auto mask = static_cast<unsigned char>(ones(count) << bit);
    const auto part = static_cast<unsigned char>(shift_right(value, done) << bit);
    to[at / 8] = static_cast<unsigned char>((to[at / 8] & ~mask) | (part & mask));
    done += count;
  }
}

std::vector<Net> find_ports(VerilatedContext& context, const Ports& ports) {
  const VerilatedScope* scope = scope_of(context, pins);
  if (scope == nullptr || scope->varsp() == nullptr) {
    refuse(ports.title, "its class does not show its ports");
  }
  struct Port {
    const VerilatedVar* var;
    std::vector<bool> taken;  // by bit
  };
  std::map<std::string, Port> all;
  for (const auto& [name, var] : *scope->varsp()) {
    const RtlNet net = found_net(var);
    const int bits = net.width * std::max(net.words, 1);
    all[name] = {&var, std::vector<bool>(static_cast<std::size_t>(bits))};
  }
  all.erase(ports.extra);

  std::vector<Net> nets;
  const auto take = [&](const char* what, std::span<const Field> cells, int direction) {
    const std::string path = net_path(cells.front().net).path;
    const auto found = all.find(path);
    if (found == all.end()) {
      refuse(ports.title, fmt::format("{} {}: the RTL has no such port", what, path));
    }
    auto& [var, taken] = found->second;
    if ((var->vldir() & VLVD_INOUT) != direction) {
      refuse(ports.title, fmt::format("{} {}: in the RTL it is no {}", what, path, what));
    }
    const RtlNet net = found_net(*var);
    const auto places =
        places_in(net, cells, fmt::format("{}: {}", ports.title, named(what, cells.front())));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      nets.push_back(net_at(*var, places[i], cells[i].width));
      for (int bit = 0; bit < cells[i].width; ++bit) {
        const int at = std::max(places[i].word, 0) * net.width + places[i].low + bit;
        if (taken[static_cast<std::size_t>(at)]) {
          refuse(ports.title, fmt::format("{} {}: two fields have bit {}", what, path, at));
        }
        taken[static_cast<std::size_t>(at)] = true;
      }
    }
  };
  const auto take_all = [&](const char* what, const std::vector<Field>& table, int direction) {
    for (const auto& row : rows_of(table)) {
      take(what, row, direction);
      nets.resize(nets.size() + absent_after(table, row));
    }
  };
  take_all("input", ports.inputs, VLVD_IN);
  take_all("output", ports.outputs, VLVD_OUT);
  const Field clock{ports.clock, 1, Format::flag, "", "", 0, ports.clock};
  take("clock", {&clock, 1}, VLVD_IN);
  for (const auto& [name, port] : all) {
    const char* way = (port.var->vldir() & VLVD_INOUT) == VLVD_IN ? "input" : "output";
    const auto open = std::find(port.taken.begin(), port.taken.end(), false);
    if (open == port.taken.end()) continue;
    if (std::find(port.taken.begin(), port.taken.end(), true) == port.taken.end()) {
      refuse(ports.title, fmt::format("the RTL has an {} {} that no table names", way, name));
    }
    refuse(ports.title,
           fmt::format("{} {}: no field has its bit {}", way, name, open - port.taken.begin()));
  }
  return nets;
}

std::vector<Net> find_registers(VerilatedContext& context, const std::string& title,
                                std::span<const Field> cells) {
  std::vector<Net> nets;
  for (const auto& row : rows_of(cells)) {
    const std::string net = net_path(row.front().net).path;
    const std::size_t dot = is_flat(context, net) ? std::string::npos : net.rfind('.');
    std::string path = top_of(context);
    if (dot != std::string::npos) path += '.' + net.substr(0, dot);
    const VerilatedScope* scope = scope_of(context, path);
    if (scope == nullptr || scope->varsp() == nullptr) {
      refuse(title,
             fmt::format("register {}: the RTL has no instance {}", net, net.substr(0, dot)));
    }
    const std::string name = dot == std::string::npos ? net : net.substr(dot + 1);
    const auto vars = vars_of(scope, name);
    if (vars.empty()) refuse(title, fmt::format("register {}: the RTL has no such net", net));
    const VerilatedVar& var = *vars.front();
    const std::string what = fmt::format("{}: {}", title, named("register", row.front()));
    RtlNet found = found_net(var);
    if (var_in(scope, name) == nullptr) found.words = static_cast<int>(vars.size());
    const auto places = places_in(found, row, what);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (vars.size() == 1) {
        nets.push_back(net_at(var, places[i], row[i].width));
      } else {
        const auto word = static_cast<std::size_t>(places[i].word);
        nets.push_back(net_at(*vars[word], {-1, places[i].low}, row[i].width));
      }
    }
    nets.resize(nets.size() + absent_after(cells, row));
  }
  return nets;
}

}  // namespace cosim
