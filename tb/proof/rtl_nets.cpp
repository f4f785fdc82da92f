#include "tb/proof/rtl_nets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "model/core/input_error.h"
#include "tb/equiv/cells.h"
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

// What a gate gives, as a table of what it reads; what chooses is the last.
nets::Cells::Table table_of(const nets::Graph::Made& gate) {
  const auto is = [](Bit bit, std::uint64_t where) { return bit.is_inverted() ? ~where : where; };
  constexpr std::uint64_t first = 0xaa, second = 0xcc, third = 0xf0;
  if (gate.kind == nets::Gate::mux) {
    const std::uint64_t chosen = is(gate.a, third);
    return {{}, ((chosen & is(gate.b, second)) | (~chosen & is(gate.c, first))) & 0xff, 0};
  }
  const std::uint64_t a = is(gate.a, first), b = is(gate.b, second);
  return {{}, (gate.kind == nets::Gate::and_gate ? a & b : a ^ b) & 0xf, 0};
}

}  // namespace

// The module becomes a graph, of which what its named nets rest on becomes tables.
class RtlNets::Maker {
 public:
  Maker(RtlNets& made, const equiv::Module& module, const Source& source)
      : made_(made),
        module_(module),
        is_stepped_(source.clocks_are_inputs),
        gates_(
            module, graph_, [this] { return free(); }, [] { return no; }) {
    made_.cells_.name = source.top;
  }

  void make() {
    read_ports();
    for (const equiv::Cell& cell : module_.cells) {
      if (cell.is_register()) hold(cell);
    }
    read_nets();
    for (const equiv::Cell& cell : module_.cells) {
      if (cell.is_register()) clock(cell);
      if (cell.type == "$assert" || cell.type == "$cover") state(cell);
    }
    number();
  }

 private:
  struct FlipFlop {
    Bit now;
    std::optional<Bit> clock;
    bool falls = false;
    char initial = 'x';
  };

  Bit free() { return free_.emplace_back(graph_.input()); }

  void read_ports() {
    for (const equiv::Port& port : module_.ports) {
      made_.wires_[port.name].way = port.way;
      for (const int bit : port.bits) {
        if (port.way != "input" || bit < 0) continue;
        inputs_.push_back(graph_.input());
        gates_.set(bit, inputs_.back());
      }
    }
  }

  void hold(const equiv::Cell& cell) {
    if (cell.type.find("latch") != std::string::npos || !cell.has("D")) {
      throw InputError(fmt::format("{}: {} is no flip-flop", made_.cells_.name, cell.name));
    }
    for (const int bit : cell.pins.at("Q")) {
      place_[bit] = flip_flops_.size();
      flip_flops_.push_back({graph_.latch(), {}});
      gates_.hold(bit, flip_flops_.back().now);
    }
  }

  void read_nets() {
    for (const equiv::Net& net : module_.nets) {
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

  void clock(const equiv::Cell& cell) {
    const nets::Bits next = gates_.next(cell, is_stepped_);
    for (std::size_t i = 0; i < next.size(); ++i) {
      FlipFlop& own = flip_flops_[place_.at(cell.pins.at("Q")[i])];
      graph_.next(own.now, next[i]);
      if (is_stepped_ || !cell.has("CLK")) continue;
      own.clock = gates_.of(cell.pins.at("CLK").front());
      own.falls = !cell.flag("CLK_POLARITY");
    }
  }

  void state(const equiv::Cell& cell) {
    const bool asserts = cell.type == "$assert";
    const Bit is = gates_.of(cell.pins.at("A").front());
    (asserts ? unmet_ : covered_)
        .emplace_back(name_of_statement(cell.name),
                      graph_.and_of(gates_.of(cell.pins.at("EN").front()), is ^ asserts));
  }

  // Gives the nets their numbers.
  void number() {
    nets::Bits roots;
    for (const auto& [name, bit] : named_) roots.push_back(bit);
    for (const auto* all : {&unmet_, &covered_}) {
      for (const auto& [name, bit] : *all) roots.push_back(bit);
    }
    for (const FlipFlop& f : flip_flops_) {
      if (f.clock) roots.push_back(*f.clock);
    }
    const std::vector<bool> is_read = graph_.cone(roots, true);
    nets::Cells& cells = made_.cells_;
    std::map<Bit, std::string> names;
    for (const auto& [name, bit] : named_) names.try_emplace(bit, name);
    for (std::size_t i = 1; i < is_read.size(); ++i) {
      if (!is_read[i]) continue;
      const Bit bit = nets::gate_bit(i);
      const auto named = names.find(bit);
      const nets::Graph::Made& gate = graph_.gates()[i];
      const std::size_t net = net_of_[bit] =
          added(named == names.end() ? fmt::format("${}", i) : named->second);
      if (!gate.is_logic()) continue;
      nets::Cells::Table table = table_of(gate);
      if (gate.kind == nets::Gate::mux) table.of.push_back(read(gate.c));
      table.of.push_back(read(gate.kind == nets::Gate::mux ? gate.b : gate.a));
      table.of.push_back(read(gate.kind == nets::Gate::mux ? gate.a : gate.b));
      table.gives = net;
      cells.tables.push_back(std::move(table));
    }
    const auto put = [&](const nets::Bits& bits, std::vector<std::size_t>& to) {
      for (const Bit bit : bits) {
        if (is_read[bit.gate()]) to.push_back(net_of(bit));
      }
    };
    put(inputs_, cells.inputs);
    put(free_, cells.free);
    for (const FlipFlop& f : flip_flops_) {
      if (!is_read[f.now.gate()]) continue;
      nets::Cells::FlipFlop& own = cells.flip_flops.emplace_back();
      own.now = net_of(f.now);
      own.next = net_of(graph_.latches()[graph_.gates()[f.now.gate()].number].next);
      if (f.clock) own.clock = net_of(*f.clock);
      own.falls = f.falls;
      own.initial = f.initial;
    }
    for (const auto& [name, bit] : named_) made_.numbers_[name] = net_of(bit);
    for (const auto& [name, bit] : unmet_) made_.unmet_.emplace_back(name, net_of(bit));
    for (const auto& [name, bit] : covered_) made_.covered_.emplace_back(name, net_of(bit));
  }

  std::size_t added(const std::string& name) {
    made_.cells_.nets.push_back(name);
    return made_.cells_.nets.size() - 1;
  }
  std::size_t read(Bit bit) const { return net_of_.at(bit ^ bit.is_inverted()); }
  // A constant, and what is inverted, are tables of their own.
  std::size_t net_of(Bit bit) {
    const auto [at, is_new] = net_of_.try_emplace(bit, made_.cells_.nets.size());
    if (!is_new) return at->second;
    const std::size_t net = added(fmt::format("${}", bit.code));
    if (bit.is_constant()) {
      made_.cells_.tables.push_back({{}, bit == yes ? 1U : 0U, net});
    } else {
      made_.cells_.tables.push_back({{net_of_.at(!bit)}, 1, net});
    }
    return net;
  }

  RtlNets& made_;
  const equiv::Module& module_;
  bool is_stepped_;
  nets::Graph graph_;
  nets::Bits inputs_, free_;
  equiv::Cells gates_;
  std::vector<FlipFlop> flip_flops_;
  std::map<int, std::size_t> place_;  // of the flip-flop whose pin Q a bit is
  std::map<std::string, Bit> named_;
  std::vector<std::pair<std::string, Bit>> unmet_, covered_;
  std::map<Bit, std::size_t> net_of_;
};

std::string command_to_write_nets(const fs::path& folder) {
  return fmt::format("; write_json {}", (folder / kNets).string());
}
RtlNets written_nets(const fs::path& folder, const Source& source) {
  return {equiv::module_of(read_file((folder / kNets).string())), source};
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

RtlNets::RtlNets(const equiv::Module& module, const Source& source) {
  Maker(*this, module, source).make();
  find_flip_flops(source.asynchronous_reset);
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
  if (known->second != Order::both) return known->second == Order::upward;
  throw InputError(
      fmt::format("{}: {}: two arrays of this name count upward and downward", cells_.name, array));
}

std::vector<std::string> RtlNets::inputs() const {
  std::set<std::size_t> clocks;
  for (const auto& f : cells_.flip_flops) {
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

std::size_t RtlNets::net(const std::string& wire, int bit) const {
  const std::string name = wires_.at(wire).bit(wire, bit);
  const auto found = numbers_.find(name);
  if (found == numbers_.end()) throw InputError(fmt::format("{}: no net {}", cells_.name, name));
  return found->second;
}

std::vector<std::size_t> RtlNets::nets_in(const std::string& instance,
                                          const std::string& bit) const {
  std::vector<std::size_t> all;
  for (const auto& [name, net] : numbers_) {
    if (!name.ends_with(bit)) continue;
    const std::size_t path = name.size() - bit.size();
    if (path > 0 && name[path - 1] != '.') continue;
    if (is_like(name.substr(0, path == 0 ? 0 : path - 1), instance)) all.push_back(net);
  }
  return all;
}

bool RtlNets::is_sampled(std::size_t stated) const {
  std::vector<bool> is_read(cells_.nets.size());
  is_read[stated] = true;
  for (auto table = cells_.tables.rbegin(); table != cells_.tables.rend(); ++table) {
    if (!is_read[table->gives]) continue;
    for (const std::size_t net : table->of) is_read[net] = true;
  }
  const auto read = [&](std::size_t net) -> bool { return is_read[net]; };
  if (std::any_of(cells_.inputs.begin(), cells_.inputs.end(), read)) return false;
  return std::all_of(
      cells_.flip_flops.begin(), cells_.flip_flops.end(), [&](const nets::Cells::FlipFlop& f) {
        return !is_read[f.now] || cells_.nets[f.now].starts_with('$');  // yosys's own
      });
}

void RtlNets::find_flip_flops(bool asynchronous_reset) {
  shown_.resize(cells_.nets.size());
  for (std::size_t i = 0; i < cells_.flip_flops.size(); ++i) shown_[cells_.flip_flops[i].now] = i;
  if (!asynchronous_reset) return;
  std::vector<bool> many(cells_.nets.size());  // more than one
  for (const nets::Cells::Table& t : cells_.tables) {
    for (const std::size_t net : t.of) {
      many[t.gives] = many[t.gives] || many[net] ||
                      (shown_[t.gives] && shown_[net] && shown_[t.gives] != shown_[net]);
      if (shown_[net]) shown_[t.gives] = shown_[net];
    }
  }
  for (std::size_t i = 0; i < many.size(); ++i) {
    if (many[i]) shown_[i].reset();
  }
}

}  // namespace cosim::proof
