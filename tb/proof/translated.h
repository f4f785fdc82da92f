// The gates of a graph of nets as those of an and-inverter graph.
#pragma once

#include <cstddef>
#include <vector>

#include "tb/nets/graph.h"
#include "tb/proof/aig.h"

namespace cosim::proof {

/// Of one graph, made in another as far as it is asked for.
class Translated {
 public:
  Translated(const nets::Graph& from, Aig& to)
      : from_(from), to_(to), lits_(from.gates().size()), is_made_(from.gates().size()) {
    give(nets::no, 0);
  }
  /// An input of the one is this of the other.
  void give(nets::Bit input, Aig::Lit lit) {
    lits_[input.gate()] = lit;
    is_made_[input.gate()] = true;
  }
  /// Makes all that these read; inputs that are not given are new ones.
  void make(const std::vector<nets::Bit>& roots) {
    std::vector<bool> is_needed(lits_.size());
    for (const nets::Bit root : roots) is_needed[root.gate()] = true;
    const auto& gates = from_.gates();
    for (std::size_t i = gates.size(); i-- > 0;) {
      if (!is_needed[i] || is_made_[i]) continue;
      for (const nets::Bit read : {gates[i].a, gates[i].b, gates[i].c})
        is_needed[read.gate()] = true;
    }
    for (std::size_t i = 0; i < gates.size(); ++i) {
      if (!is_needed[i] || is_made_[i]) continue;
      lits_[i] = made(gates[i]);
      is_made_[i] = true;
    }
  }
  /// That of one which was made.
  Aig::Lit of(nets::Bit bit) const { return lits_[bit.gate()] ^ (bit.is_inverted() ? 1U : 0U); }

 private:
  Aig::Lit made(const nets::Graph::Made& gate) {
    switch (gate.kind) {
      case nets::Gate::and_gate:
        return to_.and_of(of(gate.a), of(gate.b));
      case nets::Gate::xor_gate:
        return to_.xor_of(of(gate.a), of(gate.b));
      case nets::Gate::mux:
        return to_.choose(of(gate.a), of(gate.b), of(gate.c));
      default:
        return to_.input();
    }
  }
  const nets::Graph& from_;
  Aig& to_;
  std::vector<Aig::Lit> lits_;
  std::vector<bool> is_made_;
};

}  // namespace cosim::proof
