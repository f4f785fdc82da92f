// Signals that are the same in every state that is reached: equal, opposite or constant.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "tb/nets/graph.h"

namespace cosim::proof {

/// What each node of a graph is equal to: a literal of a node that stands before it, or its own.
using Same = nets::Bits;

/// Those of the nodes that `bad` depends on, as far as one step of induction shows it: true in the
/// first state whatever the inputs are, and true on a clock where it was on the clock before, which
/// a SAT solver says of all of them together (sat.h). None where that has not come to an end when
/// it is `until`, or there is no solver.
std::optional<Same> corresponding(const nets::Graph& graph, nets::Bit bad,
                                  std::chrono::steady_clock::time_point until);

/// One clock of a graph as logic of another graph, where each node is what it is equal to.
struct Frame {
  nets::Bits values;  ///< of the nodes
  nets::Bits differ;  ///< 0 all of them, where that is so of the nodes
};
/// `leaf` makes what an input is, and a latch that is equal to nothing else; or `state` has what
/// the latches are.
Frame frame_of(const nets::Graph& graph, const Same& same, nets::Graph& to,
               const std::function<nets::Bit(std::size_t node)>& leaf,
               const nets::Bits* state = nullptr);

/// What the latches hold on the next clock.
nets::Bits next_state(const nets::Graph& graph, const Frame& frame);

}  // namespace cosim::proof
