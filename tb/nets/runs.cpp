#include "tb/nets/runs.h"

namespace cosim::nets {
namespace {

using Words = std::span<const std::uint64_t>;

void evaluate(const Graph& graph, Words inputs, Words state, std::vector<std::uint64_t>& all) {
  const std::vector<Graph::Made>& gates = graph.gates();
  const auto of = [&](Bit bit) { return in_runs(all, bit); };
  for (std::size_t i = 0; i < gates.size(); ++i) {
    const Graph::Made& gate = gates[i];
    switch (gate.kind) {
      case Gate::constant:
        all[i] = 0;
        break;
      case Gate::input:
        all[i] = inputs[gate.number];
        break;
      case Gate::latch:
        all[i] = gate.number < state.size() ? state[gate.number] : 0;
        break;
      case Gate::and_gate:
        all[i] = of(gate.a) & of(gate.b);
        break;
      case Gate::xor_gate:
        all[i] = of(gate.a) ^ of(gate.b);
        break;
      case Gate::mux:
        all[i] = (of(gate.a) & of(gate.b)) | (~of(gate.a) & of(gate.c));
        break;
    }
  }
}

}  // namespace

std::vector<std::uint64_t> run(const Graph& graph, Words inputs, Words state) {
  std::vector<std::uint64_t> all(graph.gates().size());
  evaluate(graph, inputs, state, all);
  return all;
}

Runs::Runs(const Graph& graph) : graph_(graph), gates_(graph.gates().size()) {
  for (const auto& latch : graph.latches()) state_.push_back(latch.first ? ~std::uint64_t{0} : 0);
}

void Runs::clock(Words inputs) {
  evaluate(graph_, inputs, state_, gates_);
  for (std::size_t i = 0; i < state_.size(); ++i) state_[i] = of(graph_.latches()[i].next);
}

std::vector<std::vector<bool>> traced(const Graph& graph, const std::vector<std::vector<bool>>& in,
                                      const Bits& watched) {
  std::vector<std::vector<bool>> seen;
  std::vector<std::uint64_t> inputs(graph.inputs().size());
  Runs runs(graph);
  for (const std::vector<bool>& row : in) {
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = i < row.size() && row[i] ? 1 : 0;
    runs.clock(inputs);
    seen.emplace_back();
    for (const Bit bit : watched) seen.back().push_back((runs.of(bit) & 1U) != 0);
  }
  return seen;
}

}  // namespace cosim::nets
