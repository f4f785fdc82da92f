// The graph as text of BTOR2: each node is a line, behind those that it needs. Exporter alone.
#pragma once

#include <map>
#include <sstream>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/clocked/graph.h"

namespace cosim::clocked {

/// Lines of BTOR2; nodes are written as they are needed.
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

}  // namespace cosim::clocked
