// A side as gates: its cells as an and-inverter graph whose inputs are the ports, the bits that are
// not known, and the registers.
#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "model/core/input_error.h"
#include "tb/equiv/side.h"
#include "tb/nets/cells.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

// What stands in the place of a bit in a text of binary digits, the highest first.
char digit_at(const std::string& text, std::size_t bit) {
  return bit < text.size() ? text[text.size() - 1 - bit] : 'x';
}

// The parts of a pin that several ports of a memory share.
std::vector<int> part(const std::vector<int>& bits, std::size_t port, std::size_t width) {
  const auto from = bits.begin() + static_cast<std::ptrdiff_t>(port * width);
  return {from, from + static_cast<std::ptrdiff_t>(width)};
}

}  // namespace

std::string memory_port(std::size_t memory, const char* port) {
  return fmt::format("cosim.memory{}.{}", memory, port);
}

// Makes the gates of a side.
class Side::Builder {
 public:
  Builder(Side& side, Memories how, bool steps)
      : side_(side),
        how_(how),
        steps_(steps),
        cells_(*side.module_, side.logic_, [this] { return unknown(); }) {}

  void make() {
    for (const Port& port : side_.module_->ports) {
      if (port.way == "input") inputs(port.name, port.bits);
    }
    names();
    std::size_t memory = 0;
    for (const Cell& cell : side_.module_->cells) {
      if (cell.is_register()) hold(cell);
      if (cell.is_memory()) hold_memory(cell, memory++);
    }
    for (const Port& port : side_.module_->ports) {
      if (port.way != "input") outputs(port.name, port.bits);
    }
    memory = 0;
    for (const Cell& cell : side_.module_->cells) {
      if (cell.is_register()) {
        for (const Bit next : cells_.next(cell, steps_)) side_.next_.push_back(next);
        for (const int bit : cell.pins.at("Q")) side_.seen_.push_back(cells_.of(bit));
      }
      if (cell.is_memory()) next_of_memory(cell, memory++);
    }
    variables();
  }

 private:
  Bit input(Source source) {
    side_.sources_.push_back(std::move(source));
    return side_.logic_.input();
  }
  Bit unknown() { return input({Source::Kind::unknown, {}, side_.unknowns++}); }

  void inputs(const std::string& name, const std::vector<int>& bits) {
    for (std::size_t i = 0; i < bits.size(); ++i) {
      const Bit lit = input({Source::Kind::port, {name, static_cast<int>(i)}, 0});
      if (bits[i] >= 0) cells_.set(bits[i], lit);
    }
  }
  void outputs(const std::string& name, const std::vector<int>& bits) {
    for (std::size_t i = 0; i < bits.size(); ++i) {
      const Name bit{name, static_cast<int>(i)};
      side_.outputs_[bit] = cells_.of(bits[i]);
    }
  }

  // The names of each net, and its initial value.
  void names() {
    for (const Net& net : side_.module_->nets) {
      for (std::size_t i = 0; i < net.bits.size(); ++i) {
        if (net.is_named) names_[net.bits[i]].insert({net.name, static_cast<int>(i)});
        const char first = digit_at(net.init, i);
        if (!net.init.empty() && first != 'x') first_[net.bits[i]] = first == '1';
      }
    }
  }

  Bit state(Register is) {
    const std::size_t number = side_.registers.size();
    side_.registers.push_back(std::move(is));
    return input({Source::Kind::state, {}, number});
  }

  void hold(const Cell& cell) {
    for (const int bit : cell.pins.at("Q")) {
      Register is;
      is.nets = names_[bit];
      if (!is.nets.empty()) is.name = *is.nets.begin();
      const auto first = first_.find(bit);
      is.any = first == first_.end();
      is.first = !is.any && first->second;
      const Bit lit = state(std::move(is));
      if (bit < 0) continue;
      cells_.hold(bit, lit);
      register_of_[bit] = side_.registers.size() - 1;
    }
  }

  void variables() {
    for (const Net& net : side_.module_->nets) {
      std::vector<std::size_t> all;
      for (const int bit : net.bits) {
        const auto at = register_of_.find(bit);
        if (at != register_of_.end()) all.push_back(at->second);
      }
      if (net.is_named && all.size() == net.bits.size())
        side_.variables.emplace_back(net.name, all);
    }
  }

  void hold_memory(const Cell& cell, std::size_t number) {
    if (how_ == Memories::cut) {
      inputs(memory_port(number, "RD_DATA"), cell.pins.at("RD_DATA"));
      return;
    }
    const std::size_t width = cell.number("WIDTH"), low = cell.number("OFFSET");
    const std::string& first = cell.parameter("INIT");
    std::vector<Bits> words(cell.number("SIZE"));
    for (std::size_t w = 0; w < words.size(); ++w) {
      for (std::size_t i = 0; i < width; ++i) {
        const char digit = digit_at(first, w * width + i);
        const Name name{fmt::format("{}[{}]", cell.name, w + low), static_cast<int>(i)};
        words[w].push_back(
            state({cell.name.front() == '$' ? Name{} : name, digit == 'x', digit == '1', {}}));
      }
      std::vector<std::size_t> bits(width);
      std::iota(bits.begin(), bits.end(), side_.registers.size() - width);
      side_.variables.emplace_back(fmt::format("{}[{}]", cell.name, w + low), bits);
    }
    words_.push_back(words);
    cells_.hold(cell, std::move(words));
  }

  void next_of_memory(const Cell& cell, std::size_t number) {
    if (how_ == Memories::cut) {
      for (const char* pin : {"RD_ADDR", "WR_EN", "WR_ADDR", "WR_DATA"}) {
        outputs(memory_port(number, pin), cell.pins.at(pin));
      }
      return;
    }
    const std::size_t width = cell.number("WIDTH"), low = cell.number("OFFSET");
    const std::size_t address_width = cell.number("ABITS");
    std::vector<Bits> words = words_[number];
    for (std::size_t port = 0; port < cell.number("WR_PORTS"); ++port) {
      const Bits address = cells_.of(part(cell.pins.at("WR_ADDR"), port, address_width));
      const Bits data = cells_.of(part(cell.pins.at("WR_DATA"), port, width));
      Bits enable = cells_.of(part(cell.pins.at("WR_EN"), port, width));
      if (steps_) {
        const Bit clock = cells_.of(cell.pins.at("WR_CLK")[port]);
        for (Bit& bit : enable) bit = side_.logic_.and_of(bit, clock);
      }
      for (std::size_t w = 0; w < words.size(); ++w) {
        Bits here = address;
        for (std::size_t bit = 0; bit < here.size(); ++bit) {
          if (((w + low) >> bit & 1U) == 0) here[bit] = !here[bit];
        }
        const bool is_reachable = here.size() >= 64 || (w + low) >> here.size() == 0;
        const Bit is_here = is_reachable ? side_.logic_.all_of(here) : no;
        for (std::size_t i = 0; i < width; ++i) {
          words[w][i] =
              side_.logic_.mux(side_.logic_.and_of(is_here, enable[i]), data[i], words[w][i]);
        }
      }
    }
    for (const Bits& word : words) side_.next_.insert(side_.next_.end(), word.begin(), word.end());
    for (const Bits& word : words_[number]) {
      side_.seen_.insert(side_.seen_.end(), word.begin(), word.end());
    }
  }

  Side& side_;
  Memories how_;
  bool steps_;
  nets::CellGates cells_;
  std::map<int, std::set<Name>> names_;
  std::map<int, bool> first_;
  std::map<int, std::size_t> register_of_;
  std::vector<std::vector<Bits>> words_;
};

void Side::make_gates(Memories how, bool steps, const Budget& budget) {
  budget.check();
  is_cut_ = how == Memories::cut;
  logic_ = {};
  sources_.clear();
  outputs_.clear();
  next_.clear();
  seen_.clear();
  registers.clear();
  variables.clear();
  unknowns = 0;
  try {
    Builder(*this, how, steps).make();
  } catch (const Refused& error) {
    throw Refused(fmt::format("{}: {}", what_, error.what()));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", what_, error.what()));
  }
}

void Side::name_as(const Side& other) {
  std::map<Name, Name> theirs;
  for (const Register& r : other.registers) {
    for (const Name& net : r.nets) theirs.emplace(net, r.name);
  }
  for (Register& r : registers) {
    const auto same =
        std::ranges::find_if(r.nets, [&](const Name& net) { return theirs.contains(net); });
    if (same != r.nets.end()) r.name = theirs.at(*same);
  }
}

void Side::number_as_declared(const std::set<std::string>& nets) {
  std::map<std::string, int> low;
  for (const Net& net : module().nets) {
    if (nets.contains(net.name)) low[net.name] = net.low;
  }
  const auto numbered = [&](Name name) {
    const auto at = low.find(name.first);
    if (at != low.end()) name.second += at->second;
    return name;
  };
  for (Register& r : registers) {
    r.name = numbered(r.name);
    std::set<Name> all;
    for (const Name& net : r.nets) all.insert(numbered(net));
    r.nets = std::move(all);
  }
}

Side::Made Side::make(Graph& graph, const std::function<Bit(const Name&)>& input,
                      const Bits& unknown, const Bits& state) const {
  Bits value(logic_.gates().size(), no);
  const auto of = [&](Bit bit) { return placed_at(value, bit); };
  for (std::size_t n = 0; n < value.size(); ++n) {
    const Graph::Made& node = logic_.gates()[n];
    if (node.is_logic()) value[n] = remade(graph, node, value);
    if (node.kind != nets::Gate::input) continue;
    const Source& source = sources_[node.number];
    value[n] = source.kind == Source::Kind::port      ? input(source.name)
               : source.kind == Source::Kind::unknown ? unknown[source.number]
                                                      : state[source.number];
  }
  Made made;
  for (const auto& [name, lit] : outputs_) made.outputs[name] = of(lit);
  for (const Bit next : next_) made.next.push_back(of(next));
  for (const Bit seen : seen_) made.seen.push_back(of(seen));
  return made;
}

}  // namespace cosim::equiv
