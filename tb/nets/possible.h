// What the gates of a graph can be from reset on, by ternary simulation: each register that can
// change is taken for either value. It costs a few runs of the graph.
#pragma once

#include <vector>

#include "tb/nets/graph.h"

namespace cosim::nets {

/// The values that a bit may have: without one it never has it, with both it may.
struct MayBe {
  bool zero = false, one = false;
  MayBe inverted(bool is) const { return is ? MayBe{one, zero} : *this; }
};

/// Of each gate, by number, on all clocks from the first state on, whatever the inputs are.
std::vector<MayBe> possible(const Graph& graph);

}  // namespace cosim::nets
