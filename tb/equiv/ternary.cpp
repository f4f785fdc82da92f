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

struct Rails {
  Bit one = no, zero = no;  // it can be
};
Rails of(const std::vector<Rails>& all, Bit lit) {
  const Rails is = all[lit.gate()];
  return lit.is_inverted() ? Rails{is.zero, is.one} : is;
}

// An input of the same word, as likely 1 by chance.
Bit same_input(const Graph& from, std::size_t input, Graph& to) {
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
  Graph& graph = made.graph;
  std::vector<Rails> all{{no, yes}};
  for (std::size_t n = 1; n < product.graph.gates().size(); ++n) {
    const Graph::Made& node = product.graph.gates()[n];
    Rails& is = all.emplace_back();
    if (node.kind == nets::Gate::input) {
      const Bit input = same_input(product.graph, node.number, graph);
      const bool is_x = product.free.contains(nets::gate_bit(n));
      is = is_x ? Rails{yes, yes} : Rails{input, !input};
    } else if (node.kind == nets::Gate::latch) {
      const bool first = product.graph.latches()[node.number].first;
      is.one = graph.latch(first);
      is.zero = graph.latch(!first);
    } else {
      const Rails a = of(all, node.a), b = of(all, node.b), c = of(all, node.c);
      const auto either = [&](Bit then, Bit otherwise) {
        return graph.or_of(graph.and_of(a.one, then), graph.and_of(a.zero, otherwise));
      };
      is = node.kind == nets::Gate::and_gate
               ? Rails{graph.and_of(a.one, b.one), graph.or_of(a.zero, b.zero)}
           : node.kind == nets::Gate::xor_gate
               ? Rails{either(b.zero, b.one), either(b.one, b.zero)}
               : Rails{either(b.one, c.one), either(b.zero, c.zero)};
    }
  }
  for (const Graph::Latch& latch : product.graph.latches()) {
    const Rails next = of(all, latch.next);
    graph.next(all[latch.now.gate()].one, next.one);
    graph.next(all[latch.now.gate()].zero, next.zero);
  }
  const auto known = [&](Bit& lit) { lit = !of(all, lit).zero; };
  known(made.differ);
  made.bad = made.differ;
  known(made.held);
  for (auto* begins : {&made.gold_begins, &made.gate_begins}) {
    for (Bit& lit : *begins) {
      if (lit != unknown_begin) known(lit);
    }
  }
  for (auto* names : {&made.inputs, &made.beginnings}) {
    for (auto& [name, lit] : *names) known(lit);
  }
  for (auto& [name, lit] : made.any) {
    lit = of(all, lit).one;
    for (const Bit output : {made.gold.at(name), made.gate.at(name)}) {
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
