// A file of BTOR2 that the exporter wrote, read and run.
#pragma once

#include <istream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/clocked/fold.h"

namespace cosim::clocked::test {

class Netlist {
 public:
  struct Cell {
    std::string name;
    Id node;
    Id init = 0, next = 0;  // of a state; 0: none
  };
  std::vector<Cell> inputs, states, outputs, said;  // said: outputs with a colon in their names
  std::vector<Node> nodes{1};
  std::vector<Wide> constants;

  explicit Netlist(std::istream& file) {
    std::map<int, int> sorts;
    std::map<int, Id> ids;
    for (std::string text; std::getline(file, text);) {
      if (text[0] == ';') continue;
      std::istringstream line(text);
      int id = 0, sort = 0, a = 0, b = 0, c = 0;
      std::string kind, name;
      line >> id >> kind >> sort;
      if (text.find(" sort bitvec ") != std::string::npos) {
        sorts[id] = std::stoi(text.substr(text.rfind(' ')));
      } else if (kind == "input" || kind == "state") {
        line >> name;
        ids[id] = add({Op::input, sorts.at(sort)});
        (kind == "input" ? inputs : states).push_back({name, ids[id]});
      } else if (kind == "init" || kind == "next") {
        line >> a >> b;
        for (Cell& state : states) {
          if (state.node == ids.at(a)) (kind == "init" ? state.init : state.next) = ids.at(b);
        }
      } else if (kind == "output") {
        line >> name;
        const bool is_said = name.find(':') != std::string::npos;
        (is_said ? said : outputs).push_back({name, ids.at(sort)});
      } else if (kind == "consth") {
        line >> name;
        Wide value;
        for (const char digit : name)
          value = value << 4 | Wide(std::stoul(std::string(1, digit), nullptr, 16));
        constants.push_back(value);
        ids[id] = add({Op::constant, sorts.at(sort), Id(constants.size() - 1)});
      } else {
        Node n{operation(kind), sorts.at(sort)};
        line >> a >> b >> c;
        n.a = ids.at(a);
        if (operands(n.op) > 1) n.b = ids.at(b);
        if (operands(n.op) > 2) n.c = ids.at(c);
        if (n.op == Op::slice) n.b = Id(c);
        ids[id] = add(n);
      }
    }
  }

  /// Sets the values of all nodes, from those of the inputs and the states.
  void run(const std::vector<Wide>& from) {
    low_.resize(nodes.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) set(inputs[i].node, from[i]);
    for (std::size_t i = 0; i < states.size(); ++i) set(states[i].node, from[inputs.size() + i]);
    for (Id i = 1; i < nodes.size(); ++i) {
      const Node& n = nodes[i];
      if (n.op == Op::constant) set(i, constants[n.a]);
      if (operands(n.op) == 0) continue;
      const Id b = operands(n.op) > 1 ? n.b : 0, c = operands(n.op) > 2 ? n.c : 0;
      const int wa = nodes[n.a].width, wb = nodes[b].width;
      if (n.width <= 64 && wa <= 64 && wb <= 64) {
        low_[i] = folded<std::uint64_t>(n, wa, wb, low_[n.a], low_[b], low_[c]);
      } else {
        set(i, folded<Wide>(n, wa, wb, value(n.a), value(b), value(c)));
      }
    }
  }
  Wide value(Id id) const { return nodes[id].width > 64 ? wide_.at(id) : Wide(low_[id]); }

  static const std::vector<std::string>& names() {
    static const std::vector<std::string> all{"consth", "input", "not",    "add",   "sub",  "mul",
                                              "udiv",   "sdiv",  "urem",   "srem",  "and",  "or",
                                              "xor",    "sll",   "srl",    "sra",   "eq",   "ult",
                                              "slt",    "ite",   "concat", "slice", "uext", "sext"};
    return all;
  }

 private:
  void set(Id id, const Wide& value) {
    low_[id] = value[0];
    if (nodes[id].width > 64) wide_[id] = value;
  }
  Id add(const Node& n) {
    nodes.push_back(n);
    return Id(nodes.size() - 1);
  }
  static Op operation(const std::string& kind) {
    for (std::size_t i = 0; i < names().size(); ++i) {
      if (names()[i] == kind) return Op(i);
    }
    throw std::runtime_error("no operation of BTOR2: " + kind);
  }

  std::vector<std::uint64_t> low_;
  std::map<Id, Wide> wide_;  // those of more than 64 bits
};

}  // namespace cosim::clocked::test
