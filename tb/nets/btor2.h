// Golden models as files of BTOR2, which model/clocked/export.h writes: read, and put into a graph.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tb/nets/graph.h"

namespace cosim::nets {

/// A file as it was read; all lists are in its order.
struct Btor2 {
  struct Name {
    std::string name;        ///< unique among the inputs, the states or the outputs
    int width = 0;           ///< 1 to 4,096
    std::uint32_t node = 0;  ///< whose value it is
  };
  std::vector<Name> inputs, states, outputs;
  /// The reset value of each state, lowest bit first; nothing where the file has none.
  std::vector<std::optional<std::vector<bool>>> init;
  std::vector<std::uint32_t> next;  ///< the node that each state is after the clock

  struct Operation;
  /// An operation on nodes of smaller numbers; without one a constant, an input or a state.
  struct Node {
    const Operation* operation = nullptr;
    int width = 0;
    std::array<std::uint32_t, 3> of{};  ///< as many as the operation has operands
    int low = 0;                        ///< the lowest bit of a slice
    Bits constant = {};                 ///< its bits, if it is one
  };
  std::vector<Node> nodes;
};

struct Btor2::Operation {
  enum class Widths {
    same,        ///< the operands have the width of the result
    comparison,  ///< the operands have one width, the result has 1 bit
    choice,      ///< the first operand has 1 bit, the others have the width of the result
    joined,      ///< those of the operands add up to that of the result
    slice,       ///< two numbers follow, the highest and the lowest bit of the operand
    extended,    ///< a number follows, how many bits are added
  };
  /// The operands, as many as there are, and the node itself.
  struct Values {
    const Bits &a, &b, &c;
    const Node& node;
    std::size_t width() const { return static_cast<std::size_t>(node.width); }
  };
  std::string_view name;
  int operands;
  Widths widths;
  Bits (*made)(Graph& graph, const Values& of);
};
/// The operation of that name; null if there is none.
const Btor2::Operation* operation_of(std::string_view name);

/// Reads a file of bit vectors of 1 to 4,096 bits. The operations are those that export.h writes,
/// and the other comparisons; constants are of any kind. Inputs, states and outputs have names, and
/// each state has a next value. InputError "FILE:LINE: ..." for anything else, `constraint`, `bad`
/// and arrays among it.
Btor2 read_btor2(std::string_view text, const std::string& file);

struct Clocked {
  std::vector<Bits> next, outputs;
};
/// The states after a clock, and the outputs before it, where the inputs and the states are these
/// words, each of its width. Only nodes that one of them reads become gates.
Clocked placed(Graph& graph, const Btor2& model, std::span<const Bits> inputs,
               std::span<const Bits> states);

}  // namespace cosim::nets
