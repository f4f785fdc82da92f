// Finds the registers of a Verilated class by name, and compares its ports with a design's tables.
#include <fmt/core.h>
#include <fmt/format.h>
#include <verilated_syms.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <sstream>
#include <utility>

#include "model/core/input_error.h"
#include "tb/dut/named_adapter.h"
#include "tb/dut/registers.h"
#include "tb/util/place.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

const VerilatedScope* scope_of(VerilatedContext& context, const std::string& path) {
  for (const auto& [name, scope] : *context.scopeNameMap()) {
    if (plain_path(name) == path) return scope;
  }
  return nullptr;
}

RtlNet found_net(const VerilatedVar& var) {
  const int width = var.dims() == var.udims() ? 1 : var.packed().elements();
  return {width, var.udims() == 0 ? 0 : var.unpacked().elements()};
}

// What the RTL has, and where an instance has it.
struct Found {
  void* data;
  int each;  // bytes of a word
  RtlNet net;
};

Found found(const VerilatedVar& var) {
  return {var.datap(), static_cast<int>(var.entSize()), found_net(var)};
}

// Words of a memory lie one behind the other, in the order of their numbers.
Net net_at(const Found& found, const Place& place, int width) {
  auto* data = static_cast<unsigned char*>(found.data) + std::max(place.word, 0) * found.each;
  const bool whole = place.low == 0 && width == found.net.width && found.each <= 8;
  return {data, whole ? found.each : 0, place.low, width};
}

[[noreturn]] void refuse(const std::string& title, const std::string& why) {
  throw InputError(title + ": " + why);
}

// The path of the top module, of which a class may show no net, but one of what is in it. Beside it
// stands the class's own scope, which has the pins.
std::string top_of(VerilatedContext& context) {
  constexpr std::string_view above = "TOP.";
  for (const auto& [path, scope] : *context.scopeNameMap()) {
    const std::string name = path;
    if (name != "TOP.TOP" && name.starts_with(above)) {
      return name.substr(0, name.find('.', above.size()));
    }
  }
  return "TOP";
}

// Newer versions of Verilator write a name that the RTL escapes as it stands there.
const VerilatedVar* var_in(const VerilatedScope* scope, const std::string& name) {
  if (scope == nullptr || scope->varsp() == nullptr) return nullptr;
  for (const std::string& spelled : {name, '\\' + name + ' '}) {
    const auto found = scope->varsp()->find(spelled.c_str());
    if (found != scope->varsp()->end()) return &found->second;
  }
  return nullptr;
}

// A register: a net or a memory, or in RTL that a tool has written a net for each word of a memory.
struct Vars {
  std::vector<const VerilatedVar*> all;
  bool is_split = false;
};
Vars vars_of(const VerilatedScope* scope, const std::string& name) {
  if (const VerilatedVar* whole = var_in(scope, name)) return {{whole}};
  Vars words{{}, true};
  while (const VerilatedVar* word = var_in(scope, fmt::format("{}[{}]", name, words.all.size()))) {
    words.all.push_back(word);
  }
  return words;
}

// The register at a path. In RTL that was flattened the top module has a net of that name, dots and
// all.
Vars vars_at(VerilatedContext& context, const std::string& net) {
  const std::string top = top_of(context);
  const Vars flat = vars_of(scope_of(context, top), net);
  const std::size_t dot = net.rfind('.');
  if (!flat.all.empty() || dot == std::string::npos) return flat;
  return vars_of(scope_of(context, top + '.' + net.substr(0, dot)), net.substr(dot + 1));
}

// What some bits of a net are a copy of: bits of a register, by the text of cosim_rtl, or
// themselves.
struct Origin {
  std::string net;
  int low;
};
Origin origin_of(const std::string& net, int low, int width, std::string_view text) {
  for (const std::string& line : lines_in(text)) {
    std::istringstream words(line);
    std::string source, skipped, carrier;
    int bits = 0, first = 0;
    words >> source >> bits >> skipped >> skipped;
    if (source == net) break;
    while (words >> carrier >> skipped >> skipped >> first) {
      if (carrier == net && first <= low && low + width <= first + bits) {
        return {source, low - first};
      }
    }
  }
  return {net, low};
}

// How many cells behind `row` the shape does not have.
std::size_t absent_after(std::span<const Field> cells, std::span<const Field> row) {
  const auto rest = cells.subspan(static_cast<std::size_t>(row.data() - cells.data()) + row.size());
  return static_cast<std::size_t>(
      std::ranges::find_if(rest, [](const Field& f) { return f.width != 0; }) - rest.begin());
}

// What a report calls the net of a field.
std::string named(const char* what, const Field& field) {
  return fmt::format("{} {}", what, field.net);
}

// The inputs of a table that are clocks are those that the RTL's text has.
void require_clocks(const Ports& ports) {
  std::map<std::string, Edge> left;
  for (const std::string& line : lines_in(ports.clocks)) {
    const std::string_view mark = "falling ";
    const bool falls = line.starts_with(mark);
    left[falls ? line.substr(mark.size()) : line] = falls ? Edge::falling : Edge::rising;
  }
  for (const Field& f : ports.inputs) {
    if (f.edge == Edge::none) continue;
    const auto clock = left.find(f.net);
    const char* type = f.edge == Edge::rising ? "Rises" : "Falls";
    if (clock == left.end() || clock->second != f.edge) {
      refuse(ports.title,
             fmt::format("input {}: the model declares it as {}, but the RTL has no such clock",
                         f.net, type));
    }
    left.erase(clock);
  }
  for (const auto& [name, edge] : left) {
    refuse(ports.title, fmt::format("{} is a clock: the model must declare it as {}", name,
                                    edge == Edge::rising ? "Rises" : "Falls"));
  }
}

}  // namespace

std::string plain_path(std::string path) {
  for (const auto& [coded, bracket] : {std::pair{"__BRA__", "["}, std::pair{"__KET__", "]"}}) {
    for (std::size_t at; (at = path.find(coded)) != std::string::npos;) {
      path.replace(at, std::strlen(coded), bracket);
    }
  }
  return path;
}

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

std::vector<Net> find_ports(const std::vector<PortNet>& of_rtl, const Ports& ports) {
  struct Port {
    const PortNet* net;
    std::vector<bool> taken;  // by bit
  };
  std::map<std::string, Port> all;
  for (const PortNet& p : of_rtl) {
    const int bits = p.width * std::max(p.words, 1);
    all[p.name] = {&p, std::vector<bool>(static_cast<std::size_t>(bits))};
  }
  all.erase(ports.extra);

  require_clocks(ports);
  std::vector<Net> nets;
  const auto take = [&](const char* what, std::span<const Field> cells, bool goes_in) {
    const std::string path = net_path(cells.front().net).path;
    const auto found = all.find(path);
    if (found == all.end()) {
      refuse(ports.title, fmt::format("{} {}: the RTL has no such port", what, path));
    }
    auto& [port, taken] = found->second;
    if (port->is_input != goes_in) {
      refuse(ports.title, fmt::format("{} {}: in the RTL it is no {}", what, path, what));
    }
    const RtlNet net{port->width, port->words};
    const auto places =
        places_in(net, cells, fmt::format("{}: {}", ports.title, named(what, cells.front())));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      nets.push_back(net_at({port->data, port->each, net}, places[i], cells[i].width));
      for (int bit = 0; bit < cells[i].width; ++bit) {
        const int at = std::max(places[i].word, 0) * net.width + places[i].low + bit;
        if (taken[static_cast<std::size_t>(at)]) {
          refuse(ports.title, fmt::format("{} {}: two fields have bit {}", what, path, at));
        }
        taken[static_cast<std::size_t>(at)] = true;
      }
    }
  };
  const auto take_all = [&](const char* what, const std::vector<Field>& table, bool goes_in) {
    for (const auto& row : rows_of(table)) {
      if (row.front().synchronizer == nullptr) {
        take(what, row, goes_in);
      } else {
        nets.emplace_back();  // it is no pin
      }
      nets.resize(nets.size() + absent_after(table, row));
    }
  };
  take_all("input", ports.inputs, true);
  take_all("output", ports.outputs, false);
  if (*ports.clock == '\0') {
    nets.emplace_back();
  } else {
    const Field clock{ports.clock, 1, Format::flag, "", "", 0, ports.clock};
    take("clock", {&clock, 1}, true);
  }
  std::vector<std::string> unnamed;
  for (const auto& [name, port] : all) {
    const char* way = port.net->is_input ? "input" : "output";
    const auto open = std::ranges::find(port.taken, false);
    if (open == port.taken.end()) continue;
    if (std::ranges::find(port.taken, true) == port.taken.end()) {
      if (!port.net->is_input && matches_any(ports.unobserved, name)) continue;
      unnamed.push_back(fmt::format("an {} {}", way, name));
      continue;
    }
    refuse(ports.title,
           fmt::format("{} {}: no field has its bit {}", way, name, open - port.taken.begin()));
  }
  if (!unnamed.empty()) {
    refuse(ports.title,
           fmt::format("the RTL has {} that the model does not have", fmt::join(unnamed, ", ")));
  }
  return nets;
}

std::vector<Net> find_registers(VerilatedContext& context, const std::string& title,
                                std::span<const Field> cells, std::string_view text) {
  std::vector<Net> nets(absent_after(cells, cells.first(0)));
  std::vector<std::string> absent;
  for (const auto& row : rows_of(cells)) {
    const std::string net = net_path(row.front().net).path;
    const std::string what = fmt::format("{}: {}", title, named("register", row.front()));
    const auto [vars, is_split] = vars_at(context, net);
    if (vars.empty()) {
      absent.push_back(fmt::format("register {}: the RTL has no such net", net));
      continue;
    }
    RtlNet there = found_net(*vars.front());
    if (is_split) there.words = static_cast<int>(vars.size());
    const auto places = places_in(there, row, what);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (is_split) {
        const auto word = static_cast<std::size_t>(places[i].word);
        nets.push_back(net_at(found(*vars[word]), {-1, places[i].low}, row[i].width));
        continue;
      }
      const Origin origin = origin_of(net, places[i].low, row[i].width, text);
      const auto from = origin.net == net ? vars : vars_at(context, origin.net).all;
      if (from.empty()) refuse(title, fmt::format("register {}: is not shown", origin.net));
      nets.push_back(net_at(found(*from.front()), {places[i].word, origin.low}, row[i].width));
    }
    nets.resize(nets.size() + absent_after(cells, row));
  }
  if (!absent.empty()) refuse(title, fmt::format("{}", fmt::join(absent, "; ")));
  return nets;
}

}  // namespace cosim
