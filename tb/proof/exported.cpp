#include "tb/proof/exported.h"

#include <fmt/core.h>

#include <map>
#include <stdexcept>

#include "tb/nets/btor2.h"
#include "tb/nets/exported.h"

namespace cosim::proof {
namespace {

using nets::Btor2;
using Values = std::vector<Expression>;  // of the nodes of a model

Expression literal(const nets::Bits& bits) {
  std::string digits;
  for (const nets::Bit bit : bits) digits.insert(0, bit == nets::yes ? "1" : "0");
  return Expression("#b" + digits, bit_vector(static_cast<int>(bits.size())));
}
Expression one() { return Expression("#b1", bit_vector(1)); }
Expression word_of(const Expression& condition) {
  return Expression("ite", bit_vector(1), {condition, one(), Expression("#b0", bit_vector(1))});
}

Expression applied(const Btor2::Node& node, const Values& values) {
  using Widths = Btor2::Operation::Widths;
  const std::string name(node.operation->name);
  const std::string sort = bit_vector(node.width);
  std::vector<Expression> of;
  for (int k = 0; k < node.operation->operands; ++k) {
    of.push_back(values[node.of[static_cast<std::size_t>(k)]]);
  }
  switch (node.operation->widths) {
    case Widths::same: {
      static const std::map<std::string, std::string> others{
          {"sll", "bvshl"}, {"srl", "bvlshr"}, {"sra", "bvashr"}};
      const auto other = others.find(name);
      return {other == others.end() ? "bv" + name : other->second, sort, of};
    }
    case Widths::comparison: {
      if (name == "eq") return word_of(equal(of[0], of[1]));
      if (name == "neq") return word_of(negation(equal(of[0], of[1])));
      const bool or_equal = name.ends_with("te");
      const std::string head = name.substr(0, or_equal ? name.size() - 1 : name.size());
      return word_of({"bv" + head, boolean, of});
    }
    case Widths::choice:
      return {"ite", sort, {equal(of[0], one()), of[1], of[2]}};
    case Widths::joined:
      return {"concat", sort, of};
    case Widths::slice:
      return cut(of[0], node.low, node.width);
    case Widths::extended: {
      const int from = std::stoi(of[0].sort().substr(of[0].sort().rfind(' ')));
      return {fmt::format("(_ {}_extend {})", name == "sext" ? "sign" : "zero", node.width - from),
              sort, of};
    }
  }
  throw std::logic_error("an operation of BTOR2");
}

}  // namespace
}  // namespace cosim::proof

namespace cosim::clocked {

using proof::BitVector;
using Cells = std::vector<SymbolCell<BitVector>>;

void SymbolsOf<BitVector>::give(const Asked<BitVector>& asked, const std::string& section,
                                Cells& wanted) {
  const nets::Btor2& model = nets::exported_model(asked.file + ".btor2");
  std::vector<proof::Expression> values(model.nodes.size(), proof::truth(false));
  const auto place = [&](const Cells& cells, const std::vector<nets::Btor2::Name>& names,
                         bool are_numbers) {
    if (cells.size() != names.size()) throw std::logic_error("an exported model of wide numbers");
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto& [field, value] = cells[i];
      const bool is_turned = are_numbers && field.format == Format::ones_complement;
      values[names[i].node] =
          (is_turned ? to_ones_complement(value, field.width) : value).code(field.width);
    }
  };
  place(asked.inputs, model.inputs, false);
  place(asked.states, model.states, true);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const nets::Btor2::Node& node = model.nodes[i];
    if (!node.constant.empty()) values[i] = proof::literal(node.constant);
    if (node.operation != nullptr) values[i] = proof::applied(node, values);
  }
  const bool are_next = section == "next";
  std::vector<std::uint32_t> nodes = model.next;
  if (!are_next) {
    nodes.clear();
    for (const auto& output : model.outputs) {
      const std::size_t colon = output.name.find(':');
      if (section == (colon == std::string::npos ? "out" : output.name.substr(0, colon))) {
        nodes.push_back(output.node);
      }
    }
  }
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    auto& [field, value] = wanted[i];
    const proof::Expression& code = values.at(nodes.at(i));
    value = BitVector::unsigned_code(code, field.width);
    if (are_next && field.format == Format::twos_complement) {
      value = BitVector::signed_code(code, field.width);
    }
    if (are_next && field.format == Format::ones_complement) {
      value = from_ones_complement(value, field.width);
    }
  }
}

}  // namespace cosim::clocked
