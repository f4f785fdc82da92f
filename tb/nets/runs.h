// Graphs that run: 64 runs side by side, a bit of each number for each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tb/nets/graph.h"

namespace cosim::nets {

/// What each gate gives on one clock, by number, where input number i is given inputs[i] and latch
/// number i holds state[i], or 0 where there is none.
std::vector<std::uint64_t> run(const Graph& graph, std::span<const std::uint64_t> inputs,
                               std::span<const std::uint64_t> state = {});
/// What a bit is in these runs.
inline std::uint64_t in_runs(const std::vector<std::uint64_t>& gates, Bit bit) {
  return gates[bit.gate()] ^ (bit.is_inverted() ? ~std::uint64_t{0} : 0);
}

/// Clock after clock, from the first state on.
class Runs {
 public:
  explicit Runs(const Graph& graph);
  /// The state of the next clock, a number for each latch.
  void begin(std::vector<std::uint64_t> state) { state_ = std::move(state); }
  /// The next clock, with these inputs.
  void clock(std::span<const std::uint64_t> inputs);
  /// What it is on this clock.
  std::uint64_t of(Bit bit) const { return in_runs(gates_, bit); }

 private:
  const Graph& graph_;
  std::vector<std::uint64_t> gates_, state_;
};

/// One run: the values of `watched` on every clock, from the first state on, where `in` holds those
/// of the inputs, a row a clock; an input that a row lacks is 0.
std::vector<std::vector<bool>> traced(const Graph& graph, const std::vector<std::vector<bool>>& in,
                                      const Bits& watched);

}  // namespace cosim::nets
