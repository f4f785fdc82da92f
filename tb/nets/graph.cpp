#include "tb/nets/graph.h"

#include <stdexcept>
#include <utility>

namespace cosim::nets {

std::size_t Graph::Hash::operator()(const Made& m) const {
  std::uint64_t h = static_cast<std::uint64_t>(m.kind);
  for (const Bit bit : {m.a, m.b, m.c}) h = (h ^ bit.code) * 0x9E3779B97F4A7C15U + (h >> 29);
  return static_cast<std::size_t>(h ^ (h >> 32));
}

Graph::Graph() : gates_(1) {}

Bit Graph::input() {
  inputs_.push_back({static_cast<std::uint32_t>(2 * gates_.size())});
  gates_.push_back({Gate::input});
  return inputs_.back();
}

Bit Graph::made(Gate kind, Bit a, Bit b, Bit c) {
  const Made gate{kind, a, b, c};
  const auto [at, is_new] = known_.try_emplace(gate, static_cast<std::uint32_t>(gates_.size()));
  if (is_new) gates_.push_back(gate);
  return {2 * at->second};
}

Bit Graph::and_of(Bit a, Bit b) {
  if (a.code > b.code) std::swap(a, b);
  if (a == no || a == !b) return no;
  if (a == yes || a == b) return b;
  return made(Gate::and_gate, a, b);
}

// Opposites are drawn out of it, so that one gate serves a and b, and their opposites.
Bit Graph::xor_of(Bit a, Bit b) {
  if (a.code > b.code) std::swap(a, b);
  if (a == no) return b;
  if (a == yes) return !b;
  if (a == b) return no;
  if (a == !b) return yes;
  const bool turned = a.is_inverted() != b.is_inverted();
  const Bit gate = made(Gate::xor_gate, a.is_inverted() ? !a : a, b.is_inverted() ? !b : b);
  return turned ? !gate : gate;
}

Bit Graph::mux(Bit a, Bit b, Bit c) {
  if (a == yes || b == c) return b;
  if (a == no) return c;
  if (b == !c) return xor_of(a, c);
  if (b == yes || b == a) return or_of(a, c);
  if (b == no || b == !a) return and_of(!a, c);
  if (c == no || c == a) return and_of(a, b);
  if (c == yes || c == !a) return or_of(!a, b);
  if (a.is_inverted()) return mux(!a, c, b);
  if (b.is_inverted()) return !made(Gate::mux, a, !b, !c);
  return made(Gate::mux, a, b, c);
}

Bit Graph::differ(std::span<const Bit> a, std::span<const Bit> b) {
  Bit any = no;
  for (std::size_t i = 0; i < a.size(); ++i) any = or_of(any, xor_of(a[i], b[i]));
  return any;
}

Bit Graph::lut(std::span<const Bit> of, std::uint64_t table) {
  if (of.empty()) return (table & 1) != 0 ? yes : no;
  // The last bit chooses between the halves of the table.
  const std::size_t half = std::size_t{1} << (of.size() - 1);
  const auto rest = of.first(of.size() - 1);
  return mux(of.back(), lut(rest, table >> half), lut(rest, table));
}

std::vector<Bit> placed(Graph& graph, const Graph& from, const std::map<std::size_t, Bit>& known) {
  std::vector<Bit> all;
  all.reserve(from.gates().size());
  for (const Graph::Made& gate : from.gates()) {
    const auto at = [&](Bit bit) { return placed_at(all, bit); };
    const auto is = known.find(all.size());
    if (is != known.end()) {
      all.push_back(is->second);
    } else if (gate.kind == Gate::constant) {
      all.push_back(no);
    } else if (gate.kind == Gate::and_gate) {
      all.push_back(graph.and_of(at(gate.a), at(gate.b)));
    } else if (gate.kind == Gate::xor_gate) {
      all.push_back(graph.xor_of(at(gate.a), at(gate.b)));
    } else if (gate.kind == Gate::mux) {
      all.push_back(graph.mux(at(gate.a), at(gate.b), at(gate.c)));
    } else {
      throw std::logic_error("nets: a free bit of a graph is not known in another");
    }
  }
  return all;
}

std::vector<std::uint64_t> run(const Graph& graph, std::span<const std::uint64_t> inputs) {
  std::vector<std::uint64_t> all;
  all.reserve(graph.gates().size());
  std::size_t next_input = 0;
  for (const Graph::Made& gate : graph.gates()) {
    const auto of = [&](Bit bit) { return in_runs(all, bit); };
    switch (gate.kind) {
      case Gate::constant:
        all.push_back(0);
        break;
      case Gate::input:
        all.push_back(inputs[next_input++]);
        break;
      case Gate::and_gate:
        all.push_back(of(gate.a) & of(gate.b));
        break;
      case Gate::xor_gate:
        all.push_back(of(gate.a) ^ of(gate.b));
        break;
      case Gate::mux:
        all.push_back((of(gate.a) & of(gate.b)) | (~of(gate.a) & of(gate.c)));
        break;
    }
  }
  return all;
}

}  // namespace cosim::nets
