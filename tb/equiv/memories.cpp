// Where as many ports write both, each is compared with the other side's. Else what they leave: at
// an address that is free, which stands for all, the last port that writes there decides, as in
// memory_map.
#include "tb/equiv/memories.h"

#include <vector>

namespace cosim::equiv {
namespace {

using proof::Aig;
using Lit = Aig::Lit;
using Lits = std::vector<Lit>;

Lit pin(const MemoryPorts& m, const char* port, int bit) {
  return m.made.outputs.at({memory_port(m.number, port), bit});
}

// What the ports leave at an address, by bit of the word.
struct Left {
  Lits written, data;
};

Left left_by(Aig& graph, const MemoryPorts& m, const Lits& address) {
  const auto width = static_cast<std::size_t>(m.memory.width);
  Left left{Lits(width, 0), Lits(width, 0)};
  for (int w = 0; w < m.memory.writes; ++w) {
    Lit here = 1;
    for (std::size_t bit = 0; bit < address.size(); ++bit) {
      const int at = w * m.memory.address + static_cast<int>(bit);
      const Lit other = graph.xor_of(pin(m, "WR_ADDR", at), address[bit]);
      here = graph.and_of(here, Aig::inverted(other));
    }
    for (std::size_t bit = 0; bit < width; ++bit) {
      const int at = w * m.memory.width + static_cast<int>(bit);
      const Lit writes = graph.and_of(here, pin(m, "WR_EN", at));
      left.written[bit] = graph.or_of(left.written[bit], writes);
      left.data[bit] = graph.choose(writes, pin(m, "WR_DATA", at), left.data[bit]);
    }
  }
  return left;
}

Lit leave_another(Aig& graph, const MemoryPorts& gold, const MemoryPorts& gate) {
  Lits address(static_cast<std::size_t>(gold.memory.address));
  for (Lit& bit : address) bit = graph.input();
  const Left left = left_by(graph, gold, address), other = left_by(graph, gate, address);
  Lit any = 0;
  for (std::size_t bit = 0; bit < left.written.size(); ++bit) {
    const Lit differs = graph.xor_of(left.data[bit], other.data[bit]);
    any = graph.or_of(any, graph.xor_of(left.written[bit], other.written[bit]));
    any = graph.or_of(any, graph.and_of(left.written[bit], differs));
  }
  return any;
}

// Port by port.
Lit write_another(Aig& graph, const MemoryPorts& gold, const MemoryPorts& gate) {
  const auto other = [&](const char* port, int bit) {
    return graph.xor_of(pin(gold, port, bit), pin(gate, port, bit));
  };
  Lit any = 0;
  const Memory& memory = gold.memory;
  for (int w = 0; w < memory.writes; ++w) {
    Lit written = 0;
    for (int bit = w * memory.width; bit < (w + 1) * memory.width; ++bit) {
      const Lit enable = pin(gold, "WR_EN", bit);
      written = graph.or_of(written, enable);
      any = graph.or_of(any, other("WR_EN", bit));
      any = graph.or_of(any, graph.and_of(enable, other("WR_DATA", bit)));
    }
    for (int bit = w * memory.address; bit < (w + 1) * memory.address; ++bit) {
      any = graph.or_of(any, graph.and_of(written, other("WR_ADDR", bit)));
    }
  }
  return any;
}

}  // namespace

Lit strays_of(Aig& graph, const MemoryPorts& gold, const MemoryPorts& gate) {
  Lit any = 0;
  for (int bit = 0; bit < gold.memory.reads * gold.memory.address; ++bit) {
    any = graph.or_of(any, graph.xor_of(pin(gold, "RD_ADDR", bit), pin(gate, "RD_ADDR", bit)));
  }
  const bool as_many = gold.memory.writes == gate.memory.writes;
  return graph.or_of(any,
                     as_many ? write_another(graph, gold, gate) : leave_another(graph, gold, gate));
}

}  // namespace cosim::equiv
