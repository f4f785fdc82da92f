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

Bit Graph::leaf(Gate kind, std::size_t number) {
  gates_.push_back({kind, no, no, no, static_cast<std::uint32_t>(number)});
  return gate_bit(gates_.size() - 1);
}

Bit Graph::input() {
  words_.push_back({inputs_.size()});
  return inputs_.emplace_back(leaf(Gate::input, inputs_.size()));
}

Bit Graph::input(const std::string& word) {
  const auto [at, is_new] = word_at_.try_emplace(word, words_.size());
  if (is_new) return input();
  words_[at->second].push_back(inputs_.size());
  return inputs_.emplace_back(leaf(Gate::input, inputs_.size()));
}

Bit Graph::seldom() {
  seldom_.insert(inputs_.size());
  return input();
}

Bit Graph::latch(bool first) {
  const Bit now = leaf(Gate::latch, latches_.size());
  latches_.push_back({now, first, no});
  return now;
}

void Graph::next(Bit latch, Bit value) { latches_[gates_[latch.gate()].number].next = value; }

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

Bit Graph::all_of(std::span<const Bit> bits) {
  Bit all = yes;
  for (const Bit bit : bits) all = and_of(all, bit);
  return all;
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

std::vector<bool> Graph::cone(std::span<const Bit> roots, bool over_clocks) const {
  std::vector<bool> is_in(gates_.size());
  std::vector<std::size_t> open;
  const auto put = [&](Bit bit) {
    if (is_in[bit.gate()]) return;
    is_in[bit.gate()] = true;
    open.push_back(bit.gate());
  };
  for (const Bit root : roots) put(root);
  while (!open.empty()) {
    const Made& gate = gates_[open.back()];
    open.pop_back();
    if (over_clocks && gate.kind == Gate::latch) put(latches_[gate.number].next);
    if (!gate.is_logic()) continue;
    for (const Bit read : {gate.a, gate.b, gate.c}) put(read);
  }
  return is_in;
}

Bit remade(Graph& graph, const Graph::Made& gate, const Bits& gates) {
  const Bit a = placed_at(gates, gate.a), b = placed_at(gates, gate.b);
  if (gate.kind == Gate::and_gate) return graph.and_of(a, b);
  if (gate.kind == Gate::xor_gate) return graph.xor_of(a, b);
  return graph.mux(a, b, placed_at(gates, gate.c));
}

Bits placed(Graph& graph, const Graph& from, const std::map<std::size_t, Bit>& known) {
  Bits all;
  all.reserve(from.gates().size());
  for (const Graph::Made& gate : from.gates()) {
    const auto is = known.find(all.size());
    if (is != known.end()) {
      all.push_back(is->second);
    } else if (gate.kind == Gate::constant) {
      all.push_back(no);
    } else if (gate.is_logic()) {
      all.push_back(remade(graph, gate, all));
    } else {
      throw std::logic_error("nets: a free bit of a graph is not known in another");
    }
  }
  return all;
}

Placing::Placing(const Graph& from, Graph& to)
    : from_(from), to_(to), all_(from.gates().size()), is_made_(from.gates().size()) {
  give(no, no);
}

void Placing::give(Bit gate, Bit is) {
  all_[gate.gate()] = is ^ gate.is_inverted();
  is_made_[gate.gate()] = true;
}

void Placing::make(std::span<const Bit> roots) {
  const auto& gates = from_.gates();
  std::vector<bool> is_needed(gates.size());
  for (const Bit root : roots) is_needed[root.gate()] = true;
  for (std::size_t i = gates.size(); i-- > 0;) {
    if (!is_needed[i] || is_made_[i] || !gates[i].is_logic()) continue;
    for (const Bit read : {gates[i].a, gates[i].b, gates[i].c}) is_needed[read.gate()] = true;
  }
  for (std::size_t i = 0; i < gates.size(); ++i) {
    if (!is_needed[i] || is_made_[i]) continue;
    all_[i] = gates[i].is_logic() ? remade(to_, gates[i], all_) : to_.input();
    is_made_[i] = true;
  }
}

}  // namespace cosim::nets
