// An order of gates in which those of a kind follow each other: what runs them one after the other
// then seldom has to find out anew what to do.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "tb/nets/graph.h"

namespace cosim::nets {

/// `gates`, by number and in rising order, so ordered that each comes behind the ones it reads and
/// that as many as can be found of kind_of(gate), 0 to 7, follow each other.
template <class KindOf>
std::vector<std::uint32_t> alike_together(const Graph& graph,
                                          const std::vector<std::uint32_t>& gates,
                                          const KindOf& kind_of) {
  const auto& made = graph.gates();
  std::vector<std::vector<std::uint32_t>> readers(made.size());
  std::vector<std::uint32_t> waits_for(made.size());
  for (const std::uint32_t gate : gates) {
    for (const Bit b : {made[gate].a, made[gate].b, made[gate].c}) {
      const auto read = static_cast<std::uint32_t>(b.gate());
      if (made[read].kind == Gate::constant || made[read].kind == Gate::input) continue;
      readers[read].push_back(gate);
      ++waits_for[gate];
    }
  }
  std::array<std::vector<std::uint32_t>, 8> ready;
  for (const std::uint32_t gate : gates) {
    if (waits_for[gate] == 0) ready[kind_of(gate)].push_back(gate);
  }
  std::vector<std::uint32_t> order;
  while (order.size() < gates.size()) {
    auto& most = *std::max_element(ready.begin(), ready.end(), [](const auto& a, const auto& b) {
      return a.size() < b.size();
    });
    // Some that become ready meanwhile are of this kind, too.
    while (!most.empty()) {
      const std::uint32_t gate = most.back();
      most.pop_back();
      order.push_back(gate);
      for (const std::uint32_t reader : readers[gate]) {
        if (--waits_for[reader] == 0) ready[kind_of(reader)].push_back(reader);
      }
    }
  }
  return order;
}

}  // namespace cosim::nets
