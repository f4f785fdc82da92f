// The inputs that the clock pins of a module are.
#include <cstddef>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/core/input_error.h"
#include "tb/nets/cells.h"

namespace cosim::nets {
namespace {

void invert(Cell& cell, const std::string& polarity, std::size_t port) {
  std::string& digits = cell.parameters.at(polarity);
  char& digit = digits.at(digits.size() - 1 - port);
  digit = digit == '1' ? '0' : '1';
}

}  // namespace

void connect_clocks(Module& module) {
  Graph graph;
  CellGates cells(module, graph, [&] { return graph.input(); });
  std::map<Bit, int> input_of;
  std::unordered_map<int, bool> is_input;
  for (const netlist::Port& port : module.ports) {
    if (port.way != "input") continue;
    for (const int bit : port.bits) {
      const Bit lit = graph.input();
      if (bit >= 0) cells.set(bit, lit);
      if (port.bits.size() == 1) input_of[lit] = bit;
      is_input[bit] = true;
    }
  }
  for (const Cell& cell : module.cells) {
    if (cell.is_register()) {
      for (const int bit : cell.pins.at("Q")) cells.hold(bit, graph.input());
    }
    if (cell.is_memory()) {
      for (const int bit : cell.pins.at("RD_DATA")) cells.set(bit, graph.input());
    }
  }
  const auto connect = [&](Cell& cell, const char* pin, const char* polarity) {
    const auto clocks = cell.pins.find(pin);
    if (clocks == cell.pins.end()) return;
    for (std::size_t i = 0; i < clocks->second.size(); ++i) {
      int& bit = clocks->second[i];
      if (bit < 0 || is_input.contains(bit)) continue;
      const Bit lit = cells.of(bit);
      const auto at = input_of.find(lit ^ lit.is_inverted());
      if (at == input_of.end()) continue;
      bit = at->second;
      if (lit.is_inverted()) invert(cell, polarity, i);
    }
  };
  for (Cell& cell : module.cells) {
    try {
      if (cell.is_register()) connect(cell, "CLK", "CLK_POLARITY");
      if (cell.is_memory()) connect(cell, "WR_CLK", "WR_CLK_POLARITY");
    } catch (const InputError&) {
      // Such a clock is no input.
      continue;
    }
  }
}

}  // namespace cosim::nets
