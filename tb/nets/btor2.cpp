#include "tb/nets/btor2.h"

#include <algorithm>

#include "tb/nets/words.h"

namespace cosim::nets {
namespace {

using Values = Btor2::Operation::Values;

Bits joined(Bits low, const Bits& high) {
  low.insert(low.end(), high.begin(), high.end());
  return low;
}
template <class Of>
Bits bit_by_bit(const Values& of, Of bit) {
  Bits bits;
  for (std::size_t i = 0; i < of.width(); ++i) bits.push_back(bit(of.a[i], of.b[i]));
  return bits;
}

#define OPERATION(NAME, OPERANDS, WIDTHS, MADE)                                 \
  Btor2::Operation {                                                            \
    NAME, OPERANDS, Btor2::Operation::Widths::WIDTHS,                           \
        []([[maybe_unused]] Graph& g, const Values& v) -> Bits { return MADE; } \
  }
const Btor2::Operation operations[] = {
    OPERATION("not", 1, same, inverted(v.a)),
    OPERATION("add", 2, same, sum(g, v.a, v.b)),
    OPERATION("sub", 2, same, difference(g, v.a, v.b)),
    OPERATION("mul", 2, same, product(g, v.a, v.b)),
    OPERATION("udiv", 2, same, divided(g, v.a, v.b).quotient),
    OPERATION("urem", 2, same, divided(g, v.a, v.b).remainder),
    OPERATION("sdiv", 2, same, divided_with_sign(g, v.a, v.b).quotient),
    OPERATION("srem", 2, same, divided_with_sign(g, v.a, v.b).remainder),
    OPERATION("and", 2, same, bit_by_bit(v, [&](Bit a, Bit b) { return g.and_of(a, b); })),
    OPERATION("or", 2, same, bit_by_bit(v, [&](Bit a, Bit b) { return g.or_of(a, b); })),
    OPERATION("xor", 2, same, bit_by_bit(v, [&](Bit a, Bit b) { return g.xor_of(a, b); })),
    OPERATION("sll", 2, same, shifted_up(g, v.a, v.b)),
    OPERATION("srl", 2, same, shifted_down(g, v.a, v.b, no)),
    OPERATION("sra", 2, same, shifted_down(g, v.a, v.b, v.a.back())),
    OPERATION("eq", 2, comparison, {equal(g, v.a, v.b)}),
    OPERATION("neq", 2, comparison, {!equal(g, v.a, v.b)}),
    OPERATION("ult", 2, comparison, {less(g, v.a, v.b)}),
    OPERATION("ulte", 2, comparison, {!less(g, v.b, v.a)}),
    OPERATION("ugt", 2, comparison, {less(g, v.b, v.a)}),
    OPERATION("ugte", 2, comparison, {!less(g, v.a, v.b)}),
    OPERATION("slt", 2, comparison, {less(g, v.a, v.b, true)}),
    OPERATION("slte", 2, comparison, {!less(g, v.b, v.a, true)}),
    OPERATION("sgt", 2, comparison, {less(g, v.b, v.a, true)}),
    OPERATION("sgte", 2, comparison, {!less(g, v.a, v.b, true)}),
    OPERATION("ite", 3, choice, chosen(g, v.a[0], v.b, v.c)),
    OPERATION("concat", 2, joined, joined(v.b, v.a)),
    OPERATION("slice", 1, slice,
              Bits(v.a.begin() + v.node.low, v.a.begin() + v.node.low + v.node.width)),
    OPERATION("uext", 1, extended, resized(v.a, v.width(), no)),
    OPERATION("sext", 1, extended, resized(v.a, v.width(), v.a.back())),
};
#undef OPERATION

}  // namespace

const Btor2::Operation* operation_of(std::string_view name) {
  const auto* at = std::ranges::find(operations, name, &Btor2::Operation::name);
  return at == std::end(operations) ? nullptr : at;
}

Clocked placed(Graph& graph, const Btor2& model, std::span<const Bits> inputs,
               std::span<const Bits> states) {
  const std::vector<Btor2::Node>& nodes = model.nodes;
  std::vector<bool> is_needed(nodes.size());
  for (const std::uint32_t node : model.next) is_needed[node] = true;
  for (const Btor2::Name& output : model.outputs) is_needed[output.node] = true;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (!is_needed[i] || nodes[i].operation == nullptr) continue;
    for (int k = 0; k < nodes[i].operation->operands; ++k) {
      is_needed[nodes[i].of[static_cast<std::size_t>(k)]] = true;
    }
  }
  std::vector<Bits> all(nodes.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) all[model.inputs[i].node] = inputs[i];
  for (std::size_t i = 0; i < states.size(); ++i) all[model.states[i].node] = states[i];
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Btor2::Node& node = nodes[i];
    if (!node.constant.empty()) all[i] = node.constant;
    if (!is_needed[i] || node.operation == nullptr) continue;
    all[i] = node.operation->made(graph, {all[node.of[0]], all[node.of[1]], all[node.of[2]], node});
  }
  Clocked clocked;
  for (const std::uint32_t node : model.next) clocked.next.push_back(all[node]);
  for (const Btor2::Name& output : model.outputs) clocked.outputs.push_back(all[output.node]);
  return clocked;
}

}  // namespace cosim::nets
