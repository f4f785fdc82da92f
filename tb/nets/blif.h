// Netlists as text that yosys and abc write and read: the Berkeley Logic Interchange Format.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tb/nets/cells.h"
#include "tb/nets/graph.h"

namespace cosim::nets {

/// A bit with a name: printable characters but '#', '=' and '\'; none begins with '$'.
struct Port {
  std::string name;
  Bit bit;
};

/// The gates that `outputs` come to, from `inputs`, which are free bits of the graph, each with a
/// name of its own; an output may be any bit. InputError where an output rests on a free bit that
/// no input names.
std::string to_blif(const std::string& name, const Graph& graph, const std::vector<Port>& inputs,
                    const std::vector<Port>& outputs);

/// Reads one model of logic alone, without a hierarchy: .names of 6 inputs at the most. InputError,
/// which begins with `what` and says the line, of anything else, of a net that nothing drives, or
/// two things, and of a loop.
Cells read_blif(std::string_view text, const std::string& what);

}  // namespace cosim::nets
