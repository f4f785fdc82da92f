// A file of BTOR2 that the exporter wrote as a module of Verilog, t.
#pragma once

#include <algorithm>
#include <map>

#include "tests/clocked/netlist.h"

namespace cosim::models {

/// Elements of an Array are parts of one vector, from bit 0 up.
inline std::string gold(std::istream& file) {
  using namespace clocked;
  const test::Netlist n(file);
  const auto range = [&](Id id) { return "[" + std::to_string(n.nodes[id].width - 1) + ":0] "; };
  const auto name = [](Id id) { return "n" + std::to_string(id); };
  std::string text = "module t(input clk", body, next;
  for (const auto& in : n.inputs) {
    text += ", input " + range(in.node) + in.name;
    body += "wire " + range(in.node) + name(in.node) + " = " + in.name + ";\n";
  }
  for (const auto& out : n.outputs) {
    text += ", output " + range(out.node) + out.name;
    next += "assign " + out.name + " = " + name(out.node) + ";\n";
  }
  std::map<std::string, int> widths;
  for (const auto& state : n.states) {
    std::string stem = state.name.substr(0, state.name.find('['));
    std::replace(stem.begin(), stem.end(), '.', '_');
    const int width = n.nodes[state.node].width, at = widths[stem];
    widths[stem] += width;
    const std::string part =
        stem + '[' + std::to_string(at + width - 1) + ':' + std::to_string(at) + ']';
    body += "wire " + range(state.node) + name(state.node) + " = " + part + ";\n";
    next += "initial " + part + " = " + name(state.init) + ";\nalways @(posedge clk) " + part +
            " <= " + name(state.next) + ";\n";
  }
  text += ");\n";
  for (const auto& [stem, width] : widths) {
    text += "reg [" + std::to_string(width - 1) + ":0] " + stem + ";\n";
  }
  for (Id id = 1; id < n.nodes.size(); ++id) {
    const Node& node = n.nodes[id];
    if (node.op == Op::input) continue;
    const std::string a = name(node.a), b = name(node.b), c = name(node.c);
    const auto is = [&](const std::string& op) { return a + ' ' + op + ' ' + b; };
    std::string value;
    switch (node.op) {
      case Op::constant:
        value = std::to_string(node.width) + "'b";
        for (int i = node.width - 1; i >= 0; --i) {
          value += n.constants[node.a][i / 64] >> i % 64 & 1 ? '1' : '0';
        }
        break;
      case Op::bnot:
        value = '~' + a;
        break;
      case Op::add:
        value = is("+");
        break;
      case Op::sub:
        value = is("-");
        break;
      case Op::mul:
        value = is("*");
        break;
      case Op::udiv:
        value = b + " == 0 ? ~" + b + " : " + is("/");
        break;
      case Op::urem:
        value = b + " == 0 ? " + a + " : " + is("%");
        break;
      case Op::sdiv:
        value = b + " == 0 ? 0 : $signed(" + a + ") / $signed(" + b + ")";
        break;
      case Op::srem:
        value = b + " == 0 ? $signed(" + a + ") : $signed(" + a + ") % $signed(" + b + ")";
        break;
      case Op::band:
        value = is("&");
        break;
      case Op::bor:
        value = is("|");
        break;
      case Op::bxor:
        value = is("^");
        break;
      case Op::sll:
        value = is("<<");
        break;
      case Op::srl:
        value = is(">>");
        break;
      case Op::sra:
        value = "$signed(" + a + ") >>> " + b;
        break;
      case Op::eq:
        value = is("==");
        break;
      case Op::ult:
        value = is("<");
        break;
      case Op::slt:
        value = "$signed(" + a + ") < $signed(" + b + ")";
        break;
      case Op::ite:
        value = a + " ? " + b + " : " + c;
        break;
      case Op::concat:
        value = '{' + a + ", " + b + '}';
        break;
      case Op::slice:
        value = a + " >> " + std::to_string(node.b);
        break;
      case Op::uext:
        value = a;
        break;
      case Op::sext:
        value = "$signed(" + a + ')';
        break;
      case Op::input:
        break;
    }
    body += "wire " + range(id) + name(id) + " = " + value + ";\n";
  }
  return text + body + next + "endmodule\n";
}

}  // namespace cosim::models
