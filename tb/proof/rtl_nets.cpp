#include "tb/proof/rtl_nets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "model/core/input_error.h"
#include "tb/nets/cells.h"
#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::proof {
namespace {

namespace fs = std::filesystem;
using nets::Bit, nets::no, nets::yes;

constexpr const char *kNets = "rtl.json", *kAsserts = "rtl.asserts";

// "$assert$FILE:LINE$NUMBER" where a statement has no label.
std::string name_of_statement(std::string cell) {
  if (!cell.starts_with('$')) return cell;
  cell.erase(0, cell.find('$', 1) + 1);
  cell.resize(std::min(cell.rfind('$'), cell.size()));
  return cell;
}

// By their names; those of one dimension, which have their type before them.
std::map<std::string, Order> declared_arrays(const std::vector<std::filesystem::path>& files) {
  static const std::set<std::string> no_types{"return", "else", "begin", "assign", "case", "if"};
  static const Pattern comment(R"(//[^\n]*|/\*([^*]|\*(?!/))*\*/)");
  static const Pattern declared(
      R"(([A-Za-z_]\w*)(?:\s*\[[^\];]*\])*\s+([A-Za-z_]\w*)\s*((?:\[[^\];]*\]\s*)+)[;,=])");
  static const Pattern dimension(R"(\[([^\]:]*)(:[^\]]*)?\])"), zero(R"(\s*0\s*)");
  std::map<std::string, Order> all;
  for (const std::filesystem::path& file : files) {
    const std::string text = comment.replaced(read_file(file.string()), " ");
    for (const Pattern::Parts& part : declared.all(text)) {
      if (no_types.contains(part[1])) continue;
      const auto dimensions = dimension.all(part[3]);
      const Pattern::Parts& first = dimensions.front();
      const bool is_upward = first[2].empty() || !zero.whole(first[1]).empty();
      const Order order = dimensions.size() > 1 ? Order::several
                          : is_upward           ? Order::upward
                                                : Order::downward;
      const auto [known, is_new] = all.emplace(part[2], order);
      if (!is_new && known->second != order) known->second = Order::both;
    }
  }
  return all;
}

}  // namespace

// The module becomes a graph, of which what its named nets read is kept.
class RtlNets::Maker {
 public:
  Maker(RtlNets& made, const netlist::Module& module, const Source& source)
      : made_(made),
        module_(module),
        is_stepped_(source.clocks_are_inputs),
        gates_(
            module, graph_, [this] { return free(); }, [] { return no; }) {
    made_.name_ = source.top;
  }

  void make() {
    read_ports();
    for (const netlist::Cell& cell : module_.cells) {
      if (cell.is_register()) hold(cell);
    }
    read_nets();
    for (const netlist::Cell& cell : module_.cells) {
      if (cell.is_register()) clock(cell);
      if (cell.type == "$assert" || cell.type == "$cover") state(cell);
    }
    keep();
  }

 private:
  Bit free() { return free_.emplace_back(graph_.input()); }

  void read_ports() {
    for (const netlist::Port& port : module_.ports) {
      made_.wires_[port.name].way = port.way;
      for (const int bit : port.bits) {
        if (port.way != "input" || bit < 0) continue;
        inputs_.push_back(graph_.input());
        gates_.set(bit, inputs_.back());
      }
    }
  }

  void hold(const netlist::Cell& cell) {
    if (cell.type.find("latch") != std::string::npos || !cell.has("D")) {
      throw InputError(fmt::format("{}: {} is no flip-flop", made_.name_, cell.name));
    }
    for (const int bit : cell.pins.at("Q")) {
      place_[bit] = flip_flops_.size();
      flip_flops_.push_back({graph_.latch(), no});
      gates_.hold(bit, flip_flops_.back().now);
    }
  }

  void read_nets() {
    for (const netlist::Net& net : module_.nets) {
      const int width = static_cast<int>(net.bits.size());
      for (std::size_t i = 0; i < net.init.size() && i < net.bits.size(); ++i) {
        const char digit = net.init[net.init.size() - 1 - i];
        const auto held = place_.find(net.bits[i]);
        if (digit != 'x' && held != place_.end()) flip_flops_[held->second].initial = digit;
      }
      if (!net.is_named) continue;
      Wire& wire = made_.wires_[net.name];
      wire = {wire.way, width, net.low, net.is_upward};
      for (int i = 0; i < width; ++i) {
        named_[wire.bit(net.name, i)] = gates_.of(net.bits[static_cast<std::size_t>(i)]);
      }
    }
  }

  void clock(const netlist::Cell& cell) {
    const nets::Bits next = gates_.next(cell, is_stepped_);
    for (std::size_t i = 0; i < next.size(); ++i) {
      FlipFlop& own = flip_flops_[place_.at(cell.pins.at("Q")[i])];
      own.next = next[i];
      graph_.next(own.now, own.next);
      if (is_stepped_ || !cell.has("CLK")) continue;
      own.clock = gates_.of(cell.pins.at("CLK").front());
      own.falls = !cell.flag("CLK_POLARITY");
    }
  }

  void state(const netlist::Cell& cell) {
    const bool asserts = cell.type == "$assert";
    const Bit is = gates_.of(cell.pins.at("A").front());
    (asserts ? unmet_ : covered_)
        .emplace_back(name_of_statement(cell.name),
                      graph_.and_of(gates_.of(cell.pins.at("EN").front()), is ^ asserts));
  }

  // Takes over what is read.
  void keep() {
    nets::Bits roots;
    for (const auto& [name, bit] : named_) roots.push_back(bit);
    for (const auto* all : {&unmet_, &covered_}) {
      for (const auto& [name, bit] : *all) roots.push_back(bit);
    }
    for (const FlipFlop& f : flip_flops_) roots.push_back(f.clock.value_or(no));
    const std::vector<bool> is_read = graph_.cone(roots, true);
    nets::Placing placing(graph_, made_.graph_);
    const auto give = [&](const nets::Bits& inputs, nets::Bits& to) {
      for (const Bit bit : inputs) {
        if (is_read[bit.gate()]) placing.give(bit, to.emplace_back(made_.graph_.input()));
      }
    };
    give(inputs_, made_.pins_);
    give(free_, made_.undefined_);
    std::erase_if(flip_flops_, [&](const FlipFlop& f) { return !is_read[f.now.gate()]; });
    for (const FlipFlop& f : flip_flops_) {
      placing.give(f.now, made_.graph_.latch());
      roots.push_back(f.next);
    }
    placing.make(roots);
    for (FlipFlop f : flip_flops_) {
      f.now = placing.of(f.now);
      f.next = placing.of(f.next);
      if (f.clock) f.clock = placing.of(*f.clock);
      made_.graph_.next(f.now, f.next);
      made_.flip_flops_.push_back(f);
    }
    for (const auto& [name, bit] : named_) made_.named_[name] = placing.of(bit);
    for (const auto& [name, bit] : unmet_) made_.unmet_.emplace_back(name, placing.of(bit));
    for (const auto& [name, bit] : covered_) made_.covered_.emplace_back(name, placing.of(bit));
  }

  RtlNets& made_;
  const netlist::Module& module_;
  bool is_stepped_;
  nets::Graph graph_;
  nets::Bits inputs_, free_;
  nets::CellGates gates_;
  std::vector<FlipFlop> flip_flops_;
  std::map<int, std::size_t> place_;  // of the flip-flop whose pin Q a bit is
  std::map<std::string, Bit> named_;
  Stated unmet_, covered_;
};

std::string command_to_write_nets(const fs::path& folder) {
  return fmt::format("; write_json {}", (folder / kNets).string());
}
RtlNets written_nets(const fs::path& folder, const Source& source) {
  return {netlist::module_of(read_file((folder / kNets).string())), source};
}

RtlNets::RtlNets(const Source& source)
    : RtlNets([&] {
        const Scratch scratch;
        const std::string asserts = (scratch.path() / kAsserts).string();
        run_yosys(flat_commands(source) +
                      fmt::format("; select -write {} t:$assert t:$check; {}opt_clean", asserts,
                                  source.keeps_statements ? "" : "chformal -remove; ") +
                      command_to_write_nets(scratch.path()),
                  source.top);
        RtlNets nets = written_nets(scratch.path(), source);
        nets.asserts_ = !read_file(asserts).empty();
        if (!source.written.empty()) nets.arrays_ = declared_arrays(source.files);
        return nets;
      }()) {}

RtlNets::RtlNets(const netlist::Module& module, const Source& source)
    : is_reset_asynchronous_(source.asynchronous_reset) {
  Maker(*this, module, source).make();
  find_flip_flops();
}

std::string RtlNets::Wire::bit(const std::string& name, int i) const {
  if (width == 1) return name;
  return fmt::format("{}[{}]", name, first + (is_upward ? width - 1 - i : i));
}

int RtlNets::width(const std::string& wire) const {
  const auto of = wires_.find(wire);
  return of == wires_.end() ? 0 : of->second.width;
}

// The smallest number that stands behind "memory[" in the names of the wires.
int RtlNets::first_word(const std::string& memory) const {
  const std::string begins = memory + '[';
  std::optional<int> first;
  for (auto wire = wires_.lower_bound(begins);
       wire != wires_.end() && wire->first.starts_with(begins); ++wire) {
    const int number = std::atoi(wire->first.c_str() + begins.size());
    first = std::min(first.value_or(number), number);
  }
  return first.value_or(0);
}

bool RtlNets::is_upward(const std::string& array) const {
  if (!arrays_) return false;
  const auto known = arrays_->find(array.substr(array.rfind('.') + 1));
  if (known == arrays_->end()) return false;  // parts of a vector
  if (known->second == Order::several) {
    throw InputError(
        fmt::format("{}: {}: an array of several dimensions, which slang has read, is not proved",
                    name_, array));
  }
  if (known->second != Order::both) return known->second == Order::upward;
  throw InputError(
      fmt::format("{}: {}: two arrays of this name count upward and downward", name_, array));
}

std::vector<std::string> RtlNets::inputs() const {
  std::set<Bit> clocks;
  for (const FlipFlop& f : flip_flops_) {
    if (f.clock) clocks.insert(*f.clock);
  }
  std::vector<std::string> all;
  for (const auto& [name, wire] : wires_) {
    if (wire.way == "input" && !clocks.contains(net(name, 0))) all.push_back(name);
  }
  return all;
}

std::vector<std::string> RtlNets::outputs() const {
  std::vector<std::string> all;
  for (const auto& [name, wire] : wires_) {
    if (wire.way == "output") all.push_back(name);
  }
  return all;
}

Bit RtlNets::net(const std::string& wire, int bit) const {
  const std::string name = wires_.at(wire).bit(wire, bit);
  const auto found = named_.find(name);
  if (found == named_.end()) throw InputError(fmt::format("{}: no net {}", name_, name));
  return found->second;
}

nets::Bits RtlNets::bits(const std::string& wire, int low, int width) const {
  nets::Bits all;
  for (int i = 0; i < width; ++i) all.push_back(net(wire, low + i));
  return all;
}

nets::Bits RtlNets::nets_in(const std::string& instance, const std::string& bit) const {
  nets::Bits all;
  for (const auto& [name, net] : named_) {
    if (!name.ends_with(bit)) continue;
    const std::size_t path = name.size() - bit.size();
    if (path > 0 && name[path - 1] != '.') continue;
    if (is_like(name.substr(0, path == 0 ? 0 : path - 1), instance)) all.push_back(net);
  }
  return all;
}

bool RtlNets::is_sampled(Bit stated) const {
  const std::vector<bool> is_read = graph_.cone(std::span(&stated, 1));
  if (std::ranges::any_of(pins_, [&](Bit pin) { return is_read[pin.gate()]; })) return false;
  return std::ranges::none_of(named_, [&](const auto& net) {  // else it is yosys's own
    const std::size_t gate = net.second.gate();
    return is_read[gate] && graph_.gates()[gate].kind == nets::Gate::latch;
  });
}

std::optional<std::size_t> RtlNets::shown(Bit net) const {
  const bool is_other = !is_reset_asynchronous_ && net.is_inverted();
  return is_other ? std::nullopt : shown_[net.gate()];
}

void RtlNets::find_flip_flops() {
  const auto& gates = graph_.gates();
  shown_.resize(gates.size());
  for (std::size_t i = 0; i < flip_flops_.size(); ++i) shown_[flip_flops_[i].now.gate()] = i;
  if (!is_reset_asynchronous_) return;
  std::vector<bool> many(gates.size());  // more than one
  for (std::size_t i = 0; i < gates.size(); ++i) {
    if (!gates[i].is_logic()) continue;
    for (const Bit read : {gates[i].a, gates[i].b, gates[i].c}) {
      const std::size_t of = read.gate();
      many[i] = many[i] || many[of] || (shown_[i] && shown_[of] && shown_[i] != shown_[of]);
      if (shown_[of]) shown_[i] = shown_[of];
    }
  }
  for (std::size_t i = 0; i < many.size(); ++i) {
    if (many[i]) shown_[i].reset();
  }
}

}  // namespace cosim::proof
