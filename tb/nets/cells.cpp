#include "tb/nets/cells.h"

namespace cosim::nets {

std::vector<Bit> placed(Graph& graph, const Cells& cells, std::vector<Bit> nets) {
  std::vector<Bit> of;
  for (const Cells::Table& t : cells.tables) {
    of.clear();
    for (const std::size_t net : t.of) of.push_back(nets[net]);
    nets[t.gives] = graph.lut(of, t.table);
  }
  return nets;
}

}  // namespace cosim::nets
