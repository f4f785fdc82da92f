#include "tb/proof/aig.h"

#include <fmt/core.h>

#include <algorithm>

namespace cosim::proof {
namespace {

using Lit = Aig::Lit;

// A difference of two literals as AIGER writes it: seven bits a byte, the lowest first.
void append(std::string& text, Lit delta) {
  for (; delta >= 0x80U; delta >>= 7U) text += static_cast<char>((delta & 0x7fU) | 0x80U);
  text += static_cast<char>(delta);
}

}  // namespace

Lit Aig::add(Kind kind, Lit a, Lit b) {
  nodes_.push_back({kind, a, b});
  return static_cast<Lit>(2 * (nodes_.size() - 1));
}

Lit Aig::input() {
  const Lit lit = add(Kind::input, static_cast<Lit>(inputs_.size()));
  words_.push_back({inputs_.size()});
  inputs_.push_back(lit / 2);
  return lit;
}

Lit Aig::input(const std::string& word) {
  const Lit lit = input();
  const auto [at, is_new] = word_at_.try_emplace(word, words_.size() - 1);
  if (!is_new) {
    words_.pop_back();
    words_[at->second].push_back(inputs_.size() - 1);
  }
  return lit;
}

Lit Aig::seldom() {
  seldom_.insert(inputs_.size());
  return input();
}

Lit Aig::latch(bool first) {
  const Lit lit = add(Kind::latch, static_cast<Lit>(latches_.size()));
  latches_.push_back({lit / 2, first, 0});
  return lit;
}

void Aig::next(Lit latch, Lit value) { latches_[nodes_[latch / 2].a].next = value; }

Lit Aig::and_of(Lit a, Lit b) {
  if (a > b) std::swap(a, b);
  if (a == 0 || a == inverted(b)) return 0;
  if (a == 1 || a == b) return b;
  const auto [at, is_new] = known_.try_emplace({a, b}, 0);
  if (is_new) at->second = add(Kind::both, a, b);
  return at->second;
}

Lit Aig::xor_of(Lit a, Lit b) { return or_of(and_of(a, inverted(b)), and_of(inverted(a), b)); }

Lit Aig::choose(Lit condition, Lit then, Lit otherwise) {
  return or_of(and_of(condition, then), and_of(inverted(condition), otherwise));
}

std::string Aig::aiger(Lit bad, const std::vector<std::string>& names) const {
  // Numbered as AIGER wants it: inputs, latches, gates.
  std::vector<Lit> number(nodes_.size(), 0);
  Lit next = 0;
  for (const std::uint32_t node : inputs_) number[node] = next += 2;
  for (const Latch& latch : latches_) number[latch.node] = (next += 2) + (latch.first ? 1U : 0U);
  const auto of = [&](Lit lit) { return number[lit / 2] ^ (lit & 1U); };
  std::string gates;
  std::size_t count = 0;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    if (nodes_[node].kind != Kind::both) continue;
    number[node] = next += 2;
    const Lit a = of(nodes_[node].a), b = of(nodes_[node].b);
    const Lit low = std::min(a, b), high = std::max(a, b);
    append(gates, next - high);
    append(gates, high - low);
    ++count;
  }
  std::string text =
      fmt::format("aig {} {} {} 1 {}\n", next / 2, inputs_.size(), latches_.size(), count);
  for (const Latch& latch : latches_) {
    text += fmt::format("{}\n", of(latch.next) ^ (latch.first ? 1U : 0U));
  }
  text += fmt::format("{}\n", of(bad)) + gates;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    text += fmt::format("i{} {}\n", i, i < names.size() ? names[i] : fmt::format("p{}", i));
  }
  for (std::size_t i = 0; i < latches_.size(); ++i) text += fmt::format("l{0} r{0}\n", i);
  return text;
}

std::vector<std::vector<bool>> Aig::run(const std::vector<std::vector<bool>>& in,
                                        const std::vector<Lit>& watched) const {
  std::vector<std::vector<bool>> seen;
  std::vector<bool> state, value(nodes_.size());
  for (const Latch& latch : latches_) state.push_back(latch.first);
  const auto of = [&](Lit lit) { return value[lit / 2] != ((lit & 1U) != 0); };
  for (const auto& row : in) {
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const Node& n = nodes_[node];
      if (n.kind == Kind::input) value[node] = n.a < row.size() && row[n.a];
      if (n.kind == Kind::latch) value[node] = state[n.a];
      if (n.kind == Kind::both) value[node] = of(n.a) && of(n.b);
    }
    seen.emplace_back();
    for (const Lit lit : watched) seen.back().push_back(of(lit));
    for (std::size_t i = 0; i < latches_.size(); ++i) state[i] = of(latches_[i].next);
  }
  return seen;
}

Aig::Runs::Runs(const Aig& graph) : graph_(graph), value_(graph.nodes_.size()) {
  for (std::uint32_t node = 0; node < graph.nodes_.size(); ++node) {
    if (graph.nodes_[node].kind == Kind::both) gates_.push_back(node);
  }
  for (const Latch& latch : graph.latches_) state_.push_back(latch.first ? ~std::uint64_t{0} : 0);
}

void Aig::Runs::clock(const std::vector<std::uint64_t>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) value_[graph_.inputs_[i]] = inputs[i];
  for (std::size_t i = 0; i < state_.size(); ++i) value_[graph_.latches_[i].node] = state_[i];
  for (const std::uint32_t gate : gates_) {
    value_[gate] = of(graph_.nodes_[gate].a) & of(graph_.nodes_[gate].b);
  }
  for (std::size_t i = 0; i < state_.size(); ++i) state_[i] = of(graph_.latches_[i].next);
}

}  // namespace cosim::proof
