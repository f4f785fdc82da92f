// A driver begins a job with what follows from its own state, step by step: it writes, it starts.
// Then it waits, often for a thousand clocks, and all that writes and starts in the RTL and the
// model waits, too. Where the bits of those pins are taken for constants, the gates that lead from
// them fold (constant propagation), and what answers has the same gates where it asks the same of
// the driver: both stand in one graph, each gate once.
#include "tb/lanes/quiet.h"

#include <map>
#include <utility>
#include <vector>

namespace cosim::lanes {
namespace {

using nets::Bit;
using nets::Gate;
using nets::Graph;
using Known = std::map<std::size_t, Bit>;

void know(Known& known, Bit bit, Bit is) {
  if (!bit.is_constant()) known.insert_or_assign(bit.gate(), bit.is_inverted() ? !is : is);
}

// New free bits for these.
std::vector<Bit> free_bits(Graph& graph, Known& known, const std::vector<Bit>& of) {
  std::vector<Bit> all;
  for (const Bit bit : of) {
    all.push_back(graph.input());
    know(known, bit, all.back());
  }
  return all;
}

std::vector<Bit> at(const std::vector<Bit>& gates, const std::vector<Bit>& bits) {
  std::vector<Bit> all;
  for (const Bit bit : bits) all.push_back(nets::placed_at(gates, bit));
  return all;
}

// Whether each gate follows from more than the driver.
std::vector<bool> told(const nets::DrawStep& draw, std::size_t driver) {
  std::vector<bool> all(draw.graph.gates().size());
  for (std::size_t i = 0; i < driver; ++i) all[draw.held[i].gate()] = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Graph::Made& gate = draw.graph.gates()[i];
    if (gate.kind == Gate::constant || gate.kind == Gate::input) continue;
    all[i] = all[gate.a.gate()] || all[gate.b.gate()] || all[gate.c.gate()];
  }
  return all;
}

}  // namespace

std::optional<Quiet> quiet_of(const nets::Draw& draw) {
  if (!draw.answer) return {};
  const nets::DrawStep& clock = draw.clock;
  const nets::Answer& answer = *draw.answer;
  const auto is_told = told(clock, answer.driver);
  std::vector<std::pair<Bit, Bit>> rests;  // pins, and what they are at rest
  for (std::size_t i = 0; i < clock.inputs.size(); ++i) {
    const Bit pin = clock.inputs[i];
    if (!pin.is_constant() && !is_told[pin.gate()]) rests.emplace_back(pin, answer.rest[i]);
  }
  if (rests.empty()) return {};

  Quiet quiet;
  Known known;
  quiet.loud.held = free_bits(quiet.loud.graph, known, clock.held);
  auto gates = placed(quiet.loud.graph, clock.graph, known);
  Bit loud = nets::no;
  for (const auto& [pin, rest] : rests) {
    loud = quiet.loud.graph.or_of(loud, quiet.loud.graph.xor_of(nets::placed_at(gates, pin), rest));
  }
  quiet.loud.inputs = {loud};

  known.clear();
  quiet.draw.held = free_bits(quiet.draw.graph, known, clock.held);
  for (const auto& [pin, rest] : rests) know(known, pin, rest);
  gates = placed(quiet.draw.graph, clock.graph, known);
  quiet.draw.inputs = at(gates, clock.inputs);
  quiet.draw.after = quiet.draw.held;

  Graph both;
  known.clear();
  std::vector<Bit> held = free_bits(both, known, clock.held);
  gates = placed(both, clock.graph, known);
  Known resting;
  for (const auto& [pin, rest] : rests) know(resting, nets::placed_at(gates, pin), rest);
  known.clear();
  for (std::size_t i = 0; i < held.size(); ++i) know(known, answer.held[i], held[i]);
  const auto seen = free_bits(both, known, answer.seen);
  gates = placed(both, answer.graph, known);
  const auto after = at(gates, answer.after);
  const Bit wrong = nets::placed_at(gates, answer.wrong);

  known.clear();
  quiet.answer.held = free_bits(quiet.answer.graph, known, held);
  quiet.answer.seen = free_bits(quiet.answer.graph, known, seen);
  for (const auto& [gate, is] : resting) known.insert_or_assign(gate, is);
  gates = placed(quiet.answer.graph, both, known);
  quiet.answer.after = at(gates, after);
  quiet.answer.wrong = nets::placed_at(gates, wrong);
  return quiet;
}

}  // namespace cosim::lanes
