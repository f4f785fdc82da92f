// Differences that do not depend on what memories hold.
//
// Two gates stand for one: whether it can be 1, and whether it can be 0; an x can be both (ternary
// simulation in dual-rail encoding). It forgets that two x may be the same, so it may find less
// than there is, and never more. A memory made registers would be exact, and takes minutes where it
// has many thousand bits.
#include <algorithm>
#include <vector>

#include "tb/equiv/product.h"

namespace cosim::equiv {
namespace {

using proof::Aig;
using Lit = Aig::Lit;

struct Rails {
  Lit one = 0, zero = 0;  // it can be
};
Rails of(const std::vector<Rails>& all, Lit lit) {
  const Rails is = all[lit / 2];
  return (lit & 1U) == 0 ? is : Rails{is.zero, is.one};
}

// An input of the same word, as likely 1 by chance.
Lit same_input(const Aig& from, std::size_t input, Aig& to) {
  if (from.is_seldom(input)) return to.seldom();
  const auto& words = from.words();
  const auto has = [&](const auto& word) { return std::ranges::find(word, input) != word.end(); };
  const auto word = std::ranges::find_if(words, has);
  return to.input(std::to_string(word - words.begin()));
}

}  // namespace

Product whatever_is_free(const Product& product) {
  Product made = product;
  made.graph = {};
  Aig& graph = made.graph;
  std::vector<Rails> all{{0, 1}};
  for (std::size_t n = 1; n < product.graph.nodes().size(); ++n) {
    const Aig::Node& node = product.graph.nodes()[n];
    Rails& is = all.emplace_back();
    if (node.kind == Aig::Kind::input) {
      const Lit input = same_input(product.graph, node.a, graph);
      const bool is_x = product.free.contains(static_cast<Lit>(2 * n));
      is = is_x ? Rails{1, 1} : Rails{input, Aig::inverted(input)};
    } else if (node.kind == Aig::Kind::latch) {
      const bool first = product.graph.registers()[node.a].first;
      is.one = graph.latch(first);
      is.zero = graph.latch(!first);
    } else {
      const Rails a = of(all, node.a), b = of(all, node.b);
      is = {graph.and_of(a.one, b.one), graph.or_of(a.zero, b.zero)};
    }
  }
  for (const Aig::Latch& latch : product.graph.registers()) {
    const Rails next = of(all, latch.next);
    graph.next(all[latch.node].one, next.one);
    graph.next(all[latch.node].zero, next.zero);
  }
  const auto known = [&](Lit& lit) { lit = Aig::inverted(of(all, lit).zero); };
  known(made.differ);
  made.bad = made.differ;
  known(made.held);
  for (auto* begins : {&made.gold_begins, &made.gate_begins}) {
    for (Lit& lit : *begins) {
      if (lit != unknown_begin) known(lit);
    }
  }
  for (auto* names : {&made.inputs, &made.beginnings}) {
    for (auto& [name, lit] : *names) known(lit);
  }
  for (auto& [name, lit] : made.any) {
    lit = of(all, lit).one;
    for (const Lit output : {made.gold.at(name), made.gate.at(name)}) {
      const Rails is = of(all, output);
      lit = graph.or_of(lit, graph.and_of(is.one, is.zero));
    }
  }
  for (auto* names : {&made.gold, &made.gate}) {
    for (auto& [name, lit] : *names) known(lit);
  }
  return made;
}

}  // namespace cosim::equiv
