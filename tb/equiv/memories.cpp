// Where as many ports write both, each is compared with the other side's. Else what they leave: at
// an address that is free, which stands for all, the last port that writes there decides, as in
// memory_map.
#include "tb/equiv/product.h"

#include <vector>

namespace cosim::equiv {
namespace {

Bit pin(const MemoryPorts& m, const char* port, int bit) {
  return m.made.outputs.at({memory_port(m.number, port), bit});
}

// What the ports leave at an address, by bit of the word.
struct Left {
  Bits written, data;
};

Left left_by(Graph& graph, const MemoryPorts& m, const Bits& address) {
  const auto width = static_cast<std::size_t>(m.memory.width);
  Left left{Bits(width, no), Bits(width, no)};
  for (int w = 0; w < m.memory.writes; ++w) {
    Bit here = yes;
    for (std::size_t bit = 0; bit < address.size(); ++bit) {
      const int at = w * m.memory.address + static_cast<int>(bit);
      const Bit other = graph.xor_of(pin(m, "WR_ADDR", at), address[bit]);
      here = graph.and_of(here, !other);
    }
    for (std::size_t bit = 0; bit < width; ++bit) {
      const int at = w * m.memory.width + static_cast<int>(bit);
      const Bit writes = graph.and_of(here, pin(m, "WR_EN", at));
      left.written[bit] = graph.or_of(left.written[bit], writes);
      left.data[bit] = graph.mux(writes, pin(m, "WR_DATA", at), left.data[bit]);
    }
  }
  return left;
}

Bit leave_another(Graph& graph, const MemoryPorts& gold, const MemoryPorts& gate) {
  Bits address(static_cast<std::size_t>(gold.memory.address));
  for (Bit& bit : address) bit = graph.input();
  const Left left = left_by(graph, gold, address), other = left_by(graph, gate, address);
  Bit any = no;
  for (std::size_t bit = 0; bit < left.written.size(); ++bit) {
    const Bit differs = graph.xor_of(left.data[bit], other.data[bit]);
    any = graph.or_of(any, graph.xor_of(left.written[bit], other.written[bit]));
    any = graph.or_of(any, graph.and_of(left.written[bit], differs));
  }
  return any;
}

// Port by port.
Bit write_another(Graph& graph, const MemoryPorts& gold, const MemoryPorts& gate) {
  const auto other = [&](const char* port, int bit) {
    return graph.xor_of(pin(gold, port, bit), pin(gate, port, bit));
  };
  Bit any = no;
  const Memory& memory = gold.memory;
  for (int w = 0; w < memory.writes; ++w) {
    Bit written = no;
    for (int bit = w * memory.width; bit < (w + 1) * memory.width; ++bit) {
      const Bit enable = pin(gold, "WR_EN", bit);
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

Bit strays_of(Graph& graph, const MemoryPorts& gold, const MemoryPorts& gate) {
  Bit any = no;
  for (int bit = 0; bit < gold.memory.reads * gold.memory.address; ++bit) {
    any = graph.or_of(any, graph.xor_of(pin(gold, "RD_ADDR", bit), pin(gate, "RD_ADDR", bit)));
  }
  const bool as_many = gold.memory.writes == gate.memory.writes;
  return graph.or_of(any,
                     as_many ? write_another(graph, gold, gate) : leave_another(graph, gold, gate));
}

}  // namespace cosim::equiv
