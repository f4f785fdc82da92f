// Writes a golden model as a file of BTOR2, which model checkers of words read: btormc, Pono, AVR.
//
//   #define COSIM_SYMBOLIC  // or by the compiler's -D; with -g1, for the lines in errors
//   #include "uart.h"
//   #include "model/clocked/export.h"
//   int main() { std::cout << cosim::clocked::exported<Uart<4>>("uart").text; }
//
// The file, one line each, in this order; NAME is that of the member, "store[3]" of an element,
// "head.tag" within a struct, or the path of an At:
//
//   ; model NAME                      what is exported, and with how many ways
//   N sort bitvec W                   where a width is used first
//   N input SORT NAME                 each member of In, in their order
//   N state SORT NAME                 each register, in their order
//   N OP SORT ...                     nodes: the operations of BTOR2; constants are consth
//   N init SORT STATE CONSTANT        a register's reset value, its default initializer; an
//                                     Unreset has none
//   N next SORT STATE NODE            its value after the clock
//   N output NODE NAME                each member of Out, in their order: its value before the edge
//
// All bits are codes as RTL has them: two's complement, or ones' complement of a OnesComplement.
// Assignments to members of In that are OnesComplement may have either code of 0.
//
// An InputError is thrown where clock() has more ways than ways.most_ways, takes longer than
// ways.most_seconds, or is not the same when it is run again.
#pragma once

#ifndef COSIM_SYMBOLIC
#error "export.h belongs to the exporter: compile it with -DCOSIM_SYMBOLIC"
#endif

#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "model/clocked/model.h"

namespace cosim::clocked {

struct Exported {
  std::string text;        ///< the file
  std::uint64_t ways = 0;  ///< through clock(), and through blocks of merge()
  std::size_t nodes = 0;   ///< in the file, inputs and states among them
};

// Lines of BTOR2, of nodes as they are needed.
class Btor2 {
 public:
  std::string text() const { return out_.str(); }
  std::size_t nodes() const { return lines_.size(); }

  void comment(const std::string& words) { out_ << "; " << words << '\n'; }
  void declare(const char* kind, Id node, const std::string& name) {
    const int of = sort(graph.width(node));
    lines_[node] = ++last_;
    out_ << last_ << ' ' << kind << ' ' << of << ' ' << name << '\n';
  }
  void assign(const char* kind, Id state, Id value) {
    const int of = sort(graph.width(state)), to = line(value);
    out_ << ++last_ << ' ' << kind << ' ' << of << ' ' << line(state) << ' ' << to << '\n';
  }
  void output(Id node, const std::string& name) {
    const int at = line(node);
    out_ << ++last_ << " output " << at << ' ' << name << '\n';
  }

 private:
  int sort(int width) {
    int& at = sorts_[width];
    if (at == 0) {
      at = ++last_;
      out_ << at << " sort bitvec " << width << '\n';
    }
    return at;
  }
  // The number of a node's line, behind those that it needs. A graph may be deep: no recursion.
  int line(Id wanted) {
    std::vector<Id> open{wanted};
    while (!open.empty()) {
      const Id id = open.back();
      const Node& n = graph[id];
      const Id of[] = {n.a, n.b, n.c};
      const std::size_t before = open.size();
      if (!lines_.contains(id)) {
        for (int i = 0; i < operands(n.op); ++i) {
          if (!lines_.contains(of[i])) open.push_back(of[i]);
        }
        if (open.size() != before) continue;
        write(id, n);
      }
      open.pop_back();
    }
    return lines_[wanted];
  }
  void write(Id id, const Node& n) {
    static constexpr const char* names[] = {"consth", "input", "not",    "add",   "sub",  "mul",
                                            "udiv",   "sdiv",  "urem",   "srem",  "and",  "or",
                                            "xor",    "sll",   "srl",    "sra",   "eq",   "ult",
                                            "slt",    "ite",   "concat", "slice", "uext", "sext"};
    const int of = sort(n.width);
    lines_[id] = ++last_;
    out_ << last_ << ' ' << names[int(n.op)] << ' ' << of;
    const Id operand[] = {n.a, n.b, n.c};
    for (int i = 0; i < operands(n.op); ++i) out_ << ' ' << lines_[operand[i]];
    if (n.op == Op::constant) out_ << ' ' << hex(*graph.known(id), n.width);
    if (n.op == Op::slice) out_ << ' ' << int(n.b) + n.width - 1 << ' ' << n.b;
    if (n.op == Op::uext || n.op == Op::sext) out_ << ' ' << n.width - graph.width(n.a);
    out_ << '\n';
  }
  static std::string hex(const Wide& value, int width) {
    std::string digits;
    for (int i = (width - 1) / 4; i >= 0; --i) {
      digits += "0123456789abcdef"[value[i / 16] >> i % 16 * 4 & 15];
    }
    return digits;
  }

  std::ostringstream out_;
  int last_ = 0;
  std::map<int, int> sorts_;
  std::unordered_map<Id, int> lines_;
};

/// The model as a file, `name` in its first line and in errors.
template <class Model>
Exported exported(const std::string& name) {
  struct Register {
    Id state;
    std::optional<Id> init;
  };
  ways.begin(name);
  graph = Graph();
  Btor2 file;
  const auto declare = [&](const char* kind, const Label& label, auto& cell) {
    using Cell = std::remove_reference_t<decltype(cell)>;
    const Id node = graph.input(Cell::width);
    file.declare(kind, node, label.name);
    set_code(cell, Inside::of<UInt<Cell::width>>(node));
    return node;
  };
  auto in = zero<typename Model::In>();
  Model before{};
  std::vector<Register> registers;
  for_each_cell(in, [&](const Label& label, auto& cell) { declare("input", label, cell); });
  for_each_cell(before, [&](const Label& label, auto& cell) {
    const Id init = Inside::node(code_of(cell));
    const Id state = declare("state", label, cell);
    registers.push_back({state, label.is_unreset ? std::nullopt : std::optional(init)});
  });

  std::vector<std::string> outputs;
  const std::vector<Id> nodes = ways.join([&] {
    std::vector<Id> all;
    const auto keep = [&](const Label&, const auto& cell) {
      all.push_back(Inside::node(code_of(cell)));
    };
    Model after = before;
    const typename Model::Out out = after.clock(std::as_const(in));
    for_each_cell(after, keep);
    for_each_cell(out, keep);
    outputs.clear();
    for_each_cell(out, [&](const Label& label, const auto&) { outputs.push_back(label.name); });
    return all;
  });
  for (const Register& one : registers) {
    if (one.init) file.assign("init", one.state, *one.init);
  }
  std::size_t i = 0;
  for (const Register& one : registers) file.assign("next", one.state, nodes[i++]);
  for (const std::string& output : outputs) file.output(nodes[i++], output);
  const std::string first =
      "; model " + name + ", " + std::to_string(ways.count()) + " ways through its clock\n";
  return {first + file.text(), ways.count(), file.nodes()};
}

}  // namespace cosim::clocked
