// A model as a module of Verilog: each expression has a variable of its own width and sign, so that
// no rule of Verilog about contexts changes it.
#include <algorithm>

#include "tests/models/tree.h"

namespace cosim::models {
namespace {

class Writer {
 public:
  Writer(const Model& m, int change) : m_(m), change_(change) {}

  std::string module() {
    std::string ports = "module t(input clk, input rst", state, begin, next;
    for (const Variable& v : m_.inputs) ports += ", input " + verilog(v.type) + v.verilog;
    for (const Variable& v : m_.outputs) ports += ", output reg " + verilog(v.type) + v.verilog;
    for (const Variable& r : m_.registers) {
      const Type all = r.size > 0 ? Type{r.size * r.type.width, false} : r.type;
      const std::string name = r.verilog.substr(2);
      state += "  reg " + verilog(all) + name + ", " + r.verilog + ";\n";
      const std::string initial = replicated(r);
      state += "  initial " + name + " = " + initial + ";\n";
      begin += "    " + r.verilog + " = " + name + ";\n";
      next += "    " + name + " <= rst ? " + initial + " : " + r.verilog + ";\n";
    }
    std::size_t i = 0;
    for (const auto* some : {&m_.locals, &m_.outputs}) {
      for (const Variable& v : *some) {
        line(v.verilog + " = " + value(m_.initial[i++]) + ";");
        if (some == &m_.locals) state += "  reg " + verilog(v.type) + v.verilog + ";\n";
      }
    }
    line("if (!rst) begin");
    block(m_.body, "leave");
    line("end");
    for (const Function& f : m_.functions) {
      for (const Variable& v : f.parameters)
        state += "  reg " + verilog(v.type) + v.verilog + ";\n";
      state += "  reg " + verilog(f.result) + f.name + ";\n";
      begin += "    " + f.name + " = 0; x = 0; y = 0;\n";
    }
    return ports + ");\n" + state + declared_ +
           "  reg leave;\n  always @* begin\n    leave = 0;\n" + begin + cleared_ + code_ +
           "  end\n  always @(posedge clk) begin\n" + next + "  end\nendmodule\n";
  }
  int sites() const { return sites_; }

 private:
  static std::string constant(Type t, long value) {
    std::string bits;
    for (int i = t.width - 1; i >= 0; --i) bits += value >> i & 1 ? '1' : '0';
    return std::to_string(t.width) + (t.is_signed ? "'sb" : "'b") + bits;
  }
  static std::string replicated(const Variable& r) {
    const std::string one = constant(r.type, r.initial);
    return r.size == 0 ? one : '{' + std::to_string(r.size) + '{' + one + "}}";
  }
  bool is_changed() { return sites_++ == change_; }
  void line(const std::string& text) { code_ += "    " + text + '\n'; }
  std::string declared(Type t, const std::string& stem) {
    const std::string name = stem + std::to_string(count_++);
    declared_ += "  reg " + verilog(t) + name + ";\n";
    cleared_ += "    " + name + " = 0;\n";
    return name;
  }

  /// The variable that has the value, or a constant.
  std::string value(const Expr& e) {
    if (e.op == "variable" || (e.is_int() && !e.verilog.empty())) return e.verilog;
    if (e.op == "constant" || e.is_int()) {
      return constant(e.type, is_changed() ? e.value ^ 1 : e.value);
    }
    std::vector<std::string> args;
    for (const Expr& a : e.args) args.push_back(value(a));
    const std::string name = declared(e.type, "t");
    if (e.op == "call") {
      const Function& f = m_.functions[0];
      for (std::size_t i = 0; i < 2; ++i) line(f.parameters[i].verilog + " = " + args[i] + ";");
      line("if (" + value(f.condition) + " != 0) begin");
      line(f.name + " = " + value(f.yes) + ";");
      line("end else begin");
      line(f.name + " = " + value(f.no) + ";");
      line("end");
      line(name + " = " + f.name + ";");
      return name;
    }
    const Operator* op = &written(e.op);
    const bool chooses = e.op == "mux" || e.op == "?";
    if ((op->changed[0] != 0 || chooses) && is_changed()) {
      if (chooses) std::swap(args[1], args[2]);
      if (!chooses) op = &written(op->changed);
    }
    const bool is_signed =
        std::any_of(e.args.begin(), e.args.end(), [](const Expr& a) { return a.type.is_signed; });
    std::string text;
    for (const char* c = op->verilog; *c != 0; ++c) {
      if (*c != '$') {
        text += *c;
      } else if (*++c == 'v') {
        text += e.verilog;
      } else if (*c == 'w' || *c == 'l') {
        text += std::to_string(*c == 'w' ? e.type.width : e.value);
      } else {
        const auto i = std::size_t(*c - '0');
        if (op->is_raw) {
          text += '{' + args[i] + '}';
        } else {
          text +=
              is_signed && !e.args[i].type.is_signed ? "$signed({1'b0, " + args[i] + "})" : args[i];
        }
      }
    }
    line(name + " = " + text + ";");
    return name;
  }

  void assign(const Stmt& s) {
    const Type part{s.width,
                    s.part.empty() || s.part == "element" ? s.target.type.is_signed : false};
    const int all = s.target.type.width * std::max(1, s.target.size);
    std::string at = std::to_string(s.low);
    if (!s.args.empty()) at = '{' + value(s.args[0]) + '}';
    if (s.part == "element") at += " * 32'd" + std::to_string(s.width);
    Expr from = s.value;
    if (!s.op.empty()) {
      const std::string before = declared(part, "b");
      line(before + " = " +
           (s.part.empty() ? s.target.verilog : '{' + s.target.verilog + "} >> " + at) + ";");
      const Expr old{"variable", part, {}, before, before};
      const bool is_signed = part.is_signed || from.type.is_signed;
      from = {s.op, {std::max(part.width, from.type.width) + 2, is_signed}, {old, from}};
    }
    const std::string to = value(from);
    if (is_changed()) return;
    if (s.part.empty()) return line(s.target.verilog + " = " + to + ";");
    const std::string bits = declared({s.width, false}, "p"), mask = declared({all, false}, "m");
    line(bits + " = " + to + ";");
    line(mask + " = {" + std::to_string(s.width) + "{1'b1}};");
    line(mask + " = " + mask + " << (" + at + ");");
    const std::string kept = declared({all, false}, "k");
    line(kept + " = " + bits + ";");
    line(kept + " = " + kept + " << (" + at + ");");
    line(s.target.verilog + " = ({" + s.target.verilog + "} & ~" + mask + ") | " + kept + ";");
  }

  static bool leaves(const Stmt& s, Does how) {
    if (s.does == how) return true;
    if (s.does == Does::repeat && how == Does::stop) return false;
    return std::any_of(s.blocks.begin(), s.blocks.end(), [&](const auto& block) {
      return std::any_of(block.begin(), block.end(),
                         [&](const Stmt& in) { return leaves(in, how); });
    });
  }
  /// `left`: what is 1 once the block is left.
  void block(const std::vector<Stmt>& all, const std::string& left) {
    int open = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      statement(all[i], left);
      if (!leaves(all[i], Does::leave) && !leaves(all[i], Does::stop)) continue;
      line("if (!(" + left + ")) begin");
      ++open;
    }
    while (open-- > 0) line("end");
  }
  void statement(const Stmt& s, const std::string& left) {
    switch (s.does) {
      case Does::assign:
        return assign(s);
      case Does::leave:
        return line("leave = 1;");
      case Does::stop:
        return line("if (" + value(s.value) + " != 0) " + stop_ + " = 1;");
      case Does::copy: {
        if (is_changed()) return;
        const std::string to = s.number == 1 ? "n_h" : "n_g", from = s.number == 1 ? "n_g" : "n_h";
        line(to + "_p = " + from + "_p;");
        return line(to + "_q = " + from + "_q;");
      }
      case Does::merge:
        return block(s.blocks[0], left);
      case Does::choose: {
        const std::string c = value(s.value);
        line("if (" + c + (is_changed() ? " == 0) begin" : " != 0) begin"));
        block(s.blocks[0], left);
        line("end else begin");
        block(s.blocks[1], left);
        return line("end");
      }
      case Does::select: {
        const std::string c = value(s.value);
        line("case (" + c + ")");
        for (std::size_t k = 0; k < s.blocks.size(); ++k) {
          const bool is_last = k + 1 == s.blocks.size();
          line((is_last ? "default" : constant(s.value.type, long(k))) + ": begin");
          block(s.blocks[k], left);
          line("end");
        }
        return line("endcase");
      }
      case Does::repeat:
        break;
    }
    const std::string outer = stop_, i = "i" + std::to_string(s.number);
    if (declared_.find("integer " + i + ";") == std::string::npos) {
      declared_ += "  integer " + i + ";\n";
    }
    const bool shifts = !s.value.op.empty();
    std::string w;
    if (shifts) {
      line(i + " = 0;");
      const std::string begin = value(s.value);
      w = declared(s.value.type, "w");
      line(w + " = " + begin + ";");
    }
    stop_ = declared({1, false}, "stop");
    line(stop_ + " = 0;");
    line("for (" + i + " = 0; " + i + " < " + std::to_string(s.count) + "; " + i + " = " + i +
         " + 1) begin");
    line("if (!(leave || " + stop_ + ')' + (shifts ? " && " + w + " != 0" : "") + ") begin");
    block(s.blocks[0], "leave || " + stop_);
    if (shifts) line(w + " = " + w + " >> 1;");
    line("end\n    end");
    stop_ = outer;
  }

  const Model& m_;
  int change_, sites_ = 0, count_ = 0;
  std::string declared_, cleared_, code_, stop_;
};

}  // namespace

std::string module_of(const Model& m, int change, int& sites) {
  Writer writer(m, change);
  const std::string text = writer.module();
  sites = writer.sites();
  return text;
}

}  // namespace cosim::models
