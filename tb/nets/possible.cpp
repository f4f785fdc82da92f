#include "tb/nets/possible.h"

namespace cosim::nets {
namespace {

MayBe may_be_of(const Graph::Made& gate, const std::vector<MayBe>& all) {
  const auto of = [&](Bit bit) { return all[bit.gate()].inverted(bit.is_inverted()); };
  const MayBe a = of(gate.a), b = of(gate.b), c = of(gate.c);
  switch (gate.kind) {
    case Gate::and_gate:
      return {a.zero || b.zero, a.one && b.one};
    case Gate::xor_gate:
      return {(a.zero && b.zero) || (a.one && b.one), (a.zero && b.one) || (a.one && b.zero)};
    case Gate::mux:
      return {(a.one && b.zero) || (a.zero && c.zero), (a.one && b.one) || (a.zero && c.one)};
    default:
      return {true, true};
  }
}

}  // namespace

std::vector<MayBe> possible(const Graph& graph) {
  std::vector<MayBe> all(graph.gates().size());
  std::vector<MayBe> state;
  for (const auto& latch : graph.latches()) state.push_back({!latch.first, latch.first});
  for (bool changes = true; changes;) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Graph::Made& gate = graph.gates()[i];
      all[i] = gate.kind == Gate::constant ? MayBe{true, false}
               : gate.kind == Gate::latch  ? state[gate.number]
                                           : may_be_of(gate, all);
    }
    changes = false;
    for (std::size_t i = 0; i < state.size(); ++i) {
      const Bit bit = graph.latches()[i].next;
      const MayBe next = all[bit.gate()].inverted(bit.is_inverted());
      changes = changes || (next.zero && !state[i].zero) || (next.one && !state[i].one);
      state[i] = {state[i].zero || next.zero, state[i].one || next.one};
    }
  }
  return all;
}

}  // namespace cosim::nets
