#include "tb/proof/aig.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

#include "tb/support/random.h"

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
  inputs_.push_back(lit / 2);
  return lit;
}

Lit Aig::latch(bool first) {
  const Lit lit = add(Kind::latch, static_cast<Lit>(latches_.size()));
  latches_.push_back({lit / 2, first, 0});
  return lit;
}

void Aig::next(Lit latch, Lit value) { latches_[nodes_[latch / 2].a].next = value; }

Lit Aig::both(Lit a, Lit b) {
  if (a > b) std::swap(a, b);
  if (a == 0 || a == inverted(b)) return 0;
  if (a == 1 || a == b) return b;
  const auto [at, is_new] = known_.try_emplace({a, b}, 0);
  if (is_new) at->second = add(Kind::both, a, b);
  return at->second;
}

Lit Aig::differ(Lit a, Lit b) { return either(both(a, inverted(b)), both(inverted(a), b)); }

Lit Aig::choose(Lit condition, Lit then, Lit otherwise) {
  return either(both(condition, then), both(inverted(condition), otherwise));
}

std::string Aig::aiger(Lit bad) const {
  // Numbered as AIGER wants it: inputs, latches, gates. A latch that begins as 1 is kept inverted.
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
  for (std::size_t i = 0; i < inputs_.size(); ++i) text += fmt::format("i{0} p{0}\n", i);
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

std::vector<std::vector<bool>> Aig::tried(Lit bad, std::size_t clocks) const {
  constexpr std::uint64_t kSeed = 1;
  Random random(kSeed);
  // Per input: the runs in which it is held, and those in which it changes rarely.
  std::vector<std::uint64_t> held, rare, now;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    held.push_back(random.next() & random.next());
    rare.push_back(random.next() & random.next());
    now.push_back(random.next());
  }
  std::vector<std::uint64_t> value(nodes_.size()), state;
  for (const Latch& latch : latches_) state.push_back(latch.first ? ~0ULL : 0);
  const auto of = [&](Lit lit) { return value[lit / 2] ^ ((lit & 1U) != 0 ? ~0ULL : 0); };
  std::vector<std::vector<std::uint64_t>> given;
  for (std::size_t clock = 0; clock < clocks; ++clock) {
    given.push_back(now);
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const Node& n = nodes_[node];
      if (n.kind == Kind::input) value[node] = now[n.a];
      if (n.kind == Kind::latch) value[node] = state[n.a];
      if (n.kind == Kind::both) value[node] = of(n.a) & of(n.b);
    }
    if (of(bad) != 0) {
      const int one = std::countr_zero(of(bad));
      std::vector<std::vector<bool>> rows;
      for (const auto& words : given) {
        rows.emplace_back();
        for (const std::uint64_t word : words) rows.back().push_back(((word >> one) & 1U) != 0);
      }
      return rows;
    }
    for (std::size_t i = 0; i < latches_.size(); ++i) state[i] = of(latches_[i].next);
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      const std::uint64_t seldom =
          random.next() & random.next() & random.next() & random.next() & random.next();
      now[i] ^= ~held[i] & random.next() & (~rare[i] | seldom);
    }
  }
  return {};
}

}  // namespace cosim::proof
