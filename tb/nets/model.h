// A golden model as nets.
#pragma once

#include <vector>

#include "tb/nets/machine.h"
#include "tb/nets/number.h"

namespace cosim::nets {

inline Bit where_compared(Graph& graph, const Wire& w, Bit wrong) {
  return w.when ? graph.and_of(*w.when, wrong) : wrong;
}

/// A machine's nets. Its free bits are its inputs' and then its state's, as their fields have them,
/// lowest bit first.
struct Model {
  Graph graph;
  /// The free bits by names: in.NAME[BIT] and state.NAME[BIT], of an element in.NAME.ELEMENT[BIT].
  std::vector<Port> ports;
  Machine machine;
};

/// As many free bits as the field has, lowest first, with their names for model.ports.
std::vector<Bit> free_bits(Model& model, const char* kind, const Field& field);

/// The value of a state's field whose code is free. A code that no number of the field has stands
/// for its neighbour, so that every state is in range.
FreeCell free_state(Model& model, const Field& field);

/// The nets of one design at the parameters p.
template <class Design>
Model model_of(const typename Design::Params& p, bool with_ways = false) {
  Model model;
  const auto state = [&](const Field& f) { return free_state(model, f); };
  const auto input = [&](const Field& f) {
    const std::vector<Bit> code = free_bits(model, "in", f);
    return FreeCell{Number::unsigned_code(model.graph, code), code};
  };
  model.machine = machine_of<Design>(p, state, input, with_ways);
  return model;
}

}  // namespace cosim::nets
