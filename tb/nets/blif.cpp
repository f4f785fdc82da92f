// What is written.
#include "tb/nets/blif.h"

#include <fmt/core.h>

#include "model/core/input_error.h"

namespace cosim::nets {
namespace {

// The rows of its cover that a gate has, of bits that are no opposites: each row is what a, b and c
// are to be, '-' for either.
std::vector<std::string> rows_of(const Graph::Made& g) {
  const auto is = [](Bit bit) { return bit.is_inverted() ? '0' : '1'; };
  const auto is_not = [](Bit bit) { return bit.is_inverted() ? '1' : '0'; };
  switch (g.kind) {
    case Gate::and_gate:
      return {{is(g.a), is(g.b)}};
    case Gate::xor_gate:
      return {{is(g.a), is_not(g.b)}, {is_not(g.a), is(g.b)}};
    case Gate::mux:
      return {{is(g.a), is(g.b), '-'}, {is_not(g.a), '-', is(g.c)}};
    case Gate::constant:
    case Gate::input:
    case Gate::latch:
      break;
  }
  return {};
}

}  // namespace

std::string to_blif(const std::string& name, const Graph& graph, const std::vector<Port>& inputs,
                    const std::vector<Port>& outputs) {
  std::vector<std::string> names(graph.gates().size());
  std::string text = fmt::format(".model {}\n.inputs", name);
  for (const Port& p : inputs) {
    names[p.bit.gate()] = p.name;
    text += ' ' + p.name;
  }
  text += "\n.outputs";
  for (const Port& p : outputs) text += ' ' + p.name;
  text += '\n';

  Bits roots;
  for (const Port& p : outputs) roots.push_back(p.bit);
  const std::vector<bool> is_needed = graph.cone(roots);
  for (std::size_t i = 1; i < names.size(); ++i) {
    const Graph::Made& g = graph.gates()[i];
    if (!is_needed[i]) continue;
    if (g.kind == Gate::input) {
      if (names[i].empty()) throw InputError(name + ": an output rests on a bit without a name");
      continue;
    }
    names[i] = fmt::format("${}", i);
    text += fmt::format(".names {} {}", names[g.a.gate()], names[g.b.gate()]);
    if (g.kind == Gate::mux) text += ' ' + names[g.c.gate()];
    text += ' ' + names[i] + '\n';
    for (const std::string& row : rows_of(g)) text += row + " 1\n";
  }
  for (const Port& p : outputs) {
    if (p.bit.is_constant()) {
      text += fmt::format(".names {}\n{}", p.name, p.bit == yes ? "1\n" : "");
    } else {
      text += fmt::format(".names {} {}\n{} 1\n", names[p.bit.gate()], p.name,
                          p.bit.is_inverted() ? '0' : '1');
    }
  }
  return text + ".end\n";
}

}  // namespace cosim::nets
