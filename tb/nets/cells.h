// A netlist as the cells it has: tables of truth and flip-flops.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/nets/graph.h"

namespace cosim::nets {

struct Cells {
  std::string name;
  /// The nets, each of one bit, by the tool's names. All else here names a net by its number.
  std::vector<std::string> nets;
  std::vector<std::size_t> inputs, outputs;
  std::vector<std::size_t> free;  ///< what is undefined

  struct Table {
    std::vector<std::size_t> of;  ///< 0 to 6 nets
    std::uint64_t table = 0;      ///< bit i: what it gives where `of`, lowest first, are those of i
    std::size_t gives = 0;
  };
  std::vector<Table> tables;  ///< each behind all that gives what it reads

  struct FlipFlop {
    std::size_t next = 0, now = 0;
    std::optional<std::size_t> clock{};  ///< its net; none where each step is its edge
    bool falls = false;                  ///< its edge is the falling one
    char initial = 'x';                  ///< '0', '1', or 'x' where it has no initial value
  };
  std::vector<FlipFlop> flip_flops;
};

/// Puts the cells into a graph, and gives what each net is there, by number. In `nets`, one for
/// each net, those of the inputs, of what is free and of what the flip-flops hold are given.
std::vector<Bit> placed(Graph& graph, const Cells& cells, std::vector<Bit> nets);

}  // namespace cosim::nets
