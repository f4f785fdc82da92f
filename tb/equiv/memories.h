// Memories of both sides that are one: whether both give it the same.
#pragma once

#include <cstddef>

#include "tb/equiv/side.h"
#include "tb/nets/graph.h"

namespace cosim::equiv {

/// A memory of a side, its number there, and what the side's gates give its ports.
struct MemoryPorts {
  const Memory& memory;
  std::size_t number;
  const Side::Made& made;
};

/// Whether they read another address, or leave another word at some address, whichever it is.
/// They have as many words and read ports as each other.
Bit strays_of(Graph& graph, const MemoryPorts& gold, const MemoryPorts& gate);

}  // namespace cosim::equiv
