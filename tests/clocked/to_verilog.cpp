// to_verilog MODULE CLOCK FILE.btor2: the netlist as Verilog on standard output, for `cosim equiv`.
#include <cstdio>
#include <fstream>

#include "tests/clocked/netlist.h"

using namespace cosim::clocked;

// A path below the top, or an element of an array, as one name.
static std::string name(const std::string& of) {
  return of.find_first_of(".[") == std::string::npos ? of : '\\' + of + ' ';
}
static std::string range(int width) { return "[" + std::to_string(width - 1) + ":0] "; }

static std::string expression(const test::Netlist& netlist, const Node& n) {
  const auto v = [](Id id) { return "n" + std::to_string(id); };
  const auto with_sign = [&](Id id) { return "$signed(" + v(id) + ")"; };
  const std::string a = v(n.a), b = v(n.b), width = std::to_string(n.width);
  static const char* const infix[] = {"", "",  "",  "+", "-",  "*",  "/", "",   "%",
                                      "", "&", "|", "^", "<<", ">>", "",  "==", "<"};
  switch (n.op) {
    case Op::constant: {
      std::string digits;
      for (int i = (n.width - 1) / 4; i >= 0; --i) {
        digits += "0123456789abcdef"[netlist.constants[n.a][i / 16] >> i % 16 * 4 & 15];
      }
      return width + "'h" + digits;
    }
    case Op::bnot:
      return "~" + a;
    case Op::sra:
      return with_sign(n.a) + " >>> " + b;
    case Op::slt:
      return with_sign(n.a) + " < " + with_sign(n.b);
    case Op::ite:
      return a + " ? " + b + " : " + v(n.c);
    case Op::concat:
      return "{" + a + ", " + b + "}";
    case Op::slice:
      return a + " >> " + std::to_string(n.b);
    case Op::uext:
      return a;
    case Op::sext:
      return with_sign(n.a);
    case Op::sdiv:
    case Op::srem:
      throw std::runtime_error("no signed division");
    default:
      return a + ' ' + infix[int(n.op)] + ' ' + b;
  }
}

int main(int, char** arguments) {
  std::ifstream file(arguments[3]);
  const test::Netlist netlist(file);
  const auto width = [&](const test::Netlist::Cell& cell) {
    return range(netlist.nodes[cell.node].width);
  };
  std::string ports = std::string("input ") + arguments[2], body, next;
  for (const auto& in : netlist.inputs) ports += ", input " + width(in) + name(in.name);
  for (const auto& out : netlist.outputs) ports += ", output " + width(out) + name(out.name);
  std::vector<std::string> of(netlist.nodes.size());
  for (const auto& in : netlist.inputs) of[in.node] = name(in.name);
  for (const auto& state : netlist.states) {
    of[state.node] = name(state.name);
    body += "reg " + width(state) + name(state.name) + ";\n";
    next += "  " + name(state.name) + " <= n" + std::to_string(state.next) + ";\n";
  }
  for (Id i = 1; i < netlist.nodes.size(); ++i) {
    const Node& n = netlist.nodes[i];
    body += "wire " + range(n.width) + "n" + std::to_string(i) + " = " +
            (of[i].empty() ? expression(netlist, n) : of[i]) + ";\n";
  }
  for (const auto& out : netlist.outputs) {
    body += "assign " + name(out.name) + " = n" + std::to_string(out.node) + ";\n";
  }
  std::printf("module %s(%s);\n%salways @(posedge %s) begin\n%send\nendmodule\n", arguments[1],
              ports.c_str(), body.c_str(), arguments[2], next.c_str());
}
