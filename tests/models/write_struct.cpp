// A model as a struct of C++.
#include <map>

#include "tests/models/tree.h"

namespace cosim::models {

const Operator& written(const std::string& op) {
  static const std::map<std::string, Operator> all{
      {"+", {"($0 + $1)", "$0 + $1", false, "-"}},
      {"-", {"($0 - $1)", "$0 - $1", false, "+"}},
      {"*", {"($0 * $1)", "$0 * $1", false, "+"}},
      {"/", {"($0 / $1)", "$1 == 0 ? -1 : $0 / $1", false, ""}},
      {"%", {"($0 % $1)", "$1 == 0 ? $0 : $0 % $1", false, ""}},
      {"&", {"($0 & $1)", "$0 & $1", false, "|"}},
      {"|", {"($0 | $1)", "$0 | $1", false, "^"}},
      {"^", {"($0 ^ $1)", "$0 ^ $1", false, "&"}},
      {"<", {"($0 < $1)", "$0 < $1", false, "<="}},
      {"<=", {"($0 <= $1)", "$0 <= $1", false, "<"}},
      {">", {"($0 > $1)", "$0 > $1", false, ">="}},
      {">=", {"($0 >= $1)", "$0 >= $1", false, ">"}},
      {"==", {"($0 == $1)", "$0 == $1", false, "<"}},
      {"!=", {"($0 != $1)", "$0 != $1", false, "=="}},
      {"&&", {"($0 && $1)", "$0 != 0 && $1 != 0", false, "||"}},
      {"||", {"($0 || $1)", "$0 != 0 || $1 != 0", false, "&&"}},
      {"mux", {"mux($0, $1, $2)", "$0 != 0 ? $1 : $2", false, ""}},
      {"?", {"($0 ? $t($1) : $t($2))", "$0 != 0 ? $1 : $2", false, ""}},
      {"shl", {"$t($0 << $1)", "$0 << $1", false, ">>"}},
      {">>", {"($0 >> $1)", "$0 >>> $1", false, "shl"}},
      {"cast", {"$t($0)", "$0", false, ""}},
      {"~", {"(~$0)", "~$0", false, "cast"}},
      {"neg", {"(-$0)", "-$0", false, "~"}},
      {"!", {"(!$0)", "$0 == 0", false, "reduce_and"}},
      {"reduce_and", {"reduce_and($0)", "&$0", false, "reduce_xor"}},
      {"reduce_xor", {"reduce_xor($0)", "^$0", false, "!"}},
      {"cat", {"cat($0, $1)", "{$0, $1}", true, ""}},
      {"slice", {"$0.slice<$l + $w - 1, $l>()", "$0 >> $l", true, ""}},
      {"bit", {"$0[$1]", "$0 >> $1", true, ""}},
      {"bits", {"$0.bits<$w>($1)", "$0 >> $1", true, ""}},
      {"element", {"$v[$0]", "$v >> $0 * 32'd$w", true, ""}}};
  return all.at(op);
}

namespace {

std::string text(const Expr& e) {
  if (e.op == "variable") return e.cpp;
  if (e.is_int()) return e.cpp.empty() ? std::to_string(e.value) : e.cpp;
  if (e.op == "constant") return cpp(e.type) + '(' + std::to_string(e.value) + ')';
  if (e.op == "call") return e.cpp + '(' + text(e.args[0]) + ", " + text(e.args[1]) + ')';
  std::string all;
  for (const char* c = written(e.op).cpp; *c != 0; ++c) {
    if (*c != '$') {
      all += *c;
    } else if (*++c == 't') {
      all += cpp(e.type);
    } else if (*c == 'v') {
      all += e.cpp;
    } else if (*c == 'w' || *c == 'l') {
      all += std::to_string(*c == 'w' ? e.type.width : e.value);
    } else {
      all += text(e.args[std::size_t(*c - '0')]);
    }
  }
  return all;
}

std::string place(const Stmt& s) {
  const std::string& v = s.target.cpp;
  if (s.part.empty()) return v;
  if (s.part == "slice") {
    return v + ".slice<" + std::to_string(s.low + s.width - 1) + ", " + std::to_string(s.low) +
           ">()";
  }
  if (s.part == "bits")
    return v + ".bits<" + std::to_string(s.width) + ">(" + text(s.args[0]) + ')';
  return v + '[' + text(s.args[0]) + ']';
}

std::string text(const Model& m, const std::vector<Stmt>& block) {
  std::string all = "{\n";
  for (const Stmt& s : block) {
    const std::string i = "i" + std::to_string(s.number);
    switch (s.does) {
      case Does::assign:
        all += place(s) + ' ' + s.op + "= " + text(s.value) + ";\n";
        break;
      case Does::leave:
        all += "return out;\n";
        break;
      case Does::stop:
        all += "if (" + text(s.value) + ") break;\n";
        break;
      case Does::choose:
        all += "if (" + text(s.value) + ") " + text(m, s.blocks[0]);
        if (!s.blocks[1].empty()) all += " else " + text(m, s.blocks[1]);
        break;
      case Does::copy:
        all += s.number == 1 ? "h = g;\n" : "g = h;\n";
        break;
      case Does::repeat:
        if (!s.value.op.empty()) {
          const std::string w = "w" + std::to_string(s.number);
          all += "{\nint " + i + " = 0;\n" + cpp(s.value.type) + ' ' + w + " = " + text(s.value) +
                 ";\nwhile (" + w + " != 0) {\n" + text(m, s.blocks[0]) + w + " = " + w +
                 " >> 1;\n++" + i + ";\n}\n}\n";
          break;
        }
        all += "for (int " + i + " = 0; " + i + " < " + std::to_string(s.count) + "; ++" + i +
               ") " + text(m, s.blocks[0]);
        break;
      case Does::select:
        all += "switch (" + text(s.value) + ".value()) {\n";
        for (std::size_t k = 0; k < s.blocks.size(); ++k) {
          const bool is_last = k + 1 == s.blocks.size();
          all += (is_last ? "default: " : "case " + std::to_string(k) + ": ") +
                 text(m, s.blocks[k]) + " break;\n";
        }
        all += "}\n";
        break;
      case Does::merge:
        all += "merge(*this, out";
        for (const Variable& v : m.locals) all += ", " + v.cpp;
        all += ", [&] " + text(m, s.blocks[0]) + ");\n";
    }
  }
  return all + "}\n";
}

std::string members(const std::vector<Variable>& all) {
  std::string text;
  for (const Variable& v : all) text += cpp(v.type) + ' ' + v.verilog + "; ";
  return text;
}

}  // namespace

std::string struct_of(const Model& m, const std::string& name) {
  std::string all = "struct " + name + " {\nstruct In { Bit rst; " + members(m.inputs) +
                    "};\nstruct Out { " + members(m.outputs) + "};\n";
  std::string members;
  for (const Variable& r : m.registers) {
    const std::string type = cpp(r.type);
    if (r.cpp[0] == 'g')
      members += type + ' ' + r.cpp.substr(2) + " = " + std::to_string(r.initial) + "; ";
    if (r.cpp[0] != 'r') continue;
    all += (r.size > 0 ? "Array<" + type + ", " + std::to_string(r.size) + ">" : type) + ' ' +
           r.cpp + " = " + std::to_string(r.initial) + ";\n";
  }
  all += "struct Group { " + members + "} g, h;\n";
  for (const Function& f : m.functions) {
    all += cpp(f.result) + ' ' + f.name + "(const " + cpp(f.parameters[0].type) + "& x, const " +
           cpp(f.parameters[1].type) + "& y) const {\nif (" + text(f.condition) + ") return " +
           text(f.yes) + ";\nreturn " + text(f.no) + ";\n}\n";
  }
  all += "Out clock(const In& in) {\n";
  std::size_t i = 0;
  for (const Variable& v : m.locals) {
    all += cpp(v.type) + ' ' + v.cpp + " = " + text(m.initial[i++]) + ";\n";
  }
  all += "Out out{\n";
  for (const Variable& v : m.outputs) all += '.' + v.verilog + " = " + text(m.initial[i++]) + ",\n";
  all += "};\nif (in.rst) {\n*this = " + name + "{};\nreturn out;\n}\n";
  for (const Stmt& s : m.body) {
    const std::string block = text(m, {s});
    all += block.substr(2, block.size() - 4);  // without its braces
  }
  return all + "return out;\n}\n};\n";
}

}  // namespace cosim::models
