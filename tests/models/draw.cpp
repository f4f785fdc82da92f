// Draws a model whose clock() has at most 3,000 ways, or about so many.
#include <algorithm>
#include <cmath>

#include "tests/models/tree.h"

namespace cosim::models {
namespace {

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  Model model() {
    for (const char* name : {"a", "b", "c", "d"}) m_.inputs.push_back(variable(name, "in."));
    m_.inputs[3].type = {1, false};
    for (int i = 0; i < 2 + below(3); ++i) {
      Variable v = variable("r" + std::to_string(i), "");
      if (i == 0) v.size = 4 + below(3);
      v.verilog = "n_" + v.cpp;
      v.initial = number(v.type);
      m_.registers.push_back(v);
    }
    for (const std::string member : {"p", "q"}) {
      Variable v = variable(member, "");
      v.initial = number(v.type);
      for (const std::string group : {"g", "h"}) {
        v.cpp = group + '.' + member, v.verilog = "n_" + group + '_' + member;
        m_.registers.push_back(v);
      }
    }
    m_.functions = {function()};
    scope_ = m_.inputs;
    scope_.insert(scope_.end(), m_.registers.begin(), m_.registers.end());
    for (int i = 0; i < 3; ++i) add(m_.locals, variable("v" + std::to_string(i), ""));
    for (int i = 0; i < 3; ++i) add(m_.outputs, variable("o" + std::to_string(i), "out."));
    m_.body = block(3, 4 + below(3));
    for (const Variable& r : m_.registers) {  // each may be observed
      Stmt s{Does::assign, m_.outputs[0], "", "^"};
      s.width = s.target.type.width, s.value = read(r);
      m_.body.push_back(s);
    }
    return m_;
  }
  double ways() const { return std::exp2(forks_); }

 private:
  int below(int n) { return int(random_() % unsigned(n)); }
  bool percent(int n) { return below(100) < n; }
  Type type() { return {percent(15) ? 1 : 1 + below(9), percent(35)}; }
  long number(Type t) { return below(1 << t.width) - (t.is_signed ? 1 << (t.width - 1) : 0); }
  Variable variable(const std::string& name, const std::string& before) {
    return {type(), before + name, name};
  }
  void add(std::vector<Variable>& to, const Variable& v) {
    m_.initial.push_back(value(2));
    to.push_back(v);
    scope_.push_back(v);
  }
  Function function() {
    Function f{"f0", type(), {variable("x", ""), variable("y", "")}};
    scope_ = f.parameters;
    f.condition = value(2), f.yes = value(2), f.no = value(2);
    forks_ = 0;
    return f;
  }

  Expr leaf() {
    if (percent(20)) {
      const Type t = type();
      return {"constant", t, {}, "", "", number(t)};
    }
    return read(scope_[std::size_t(below(int(scope_.size())))]);
  }
  Expr read(const Variable& v) {
    if (v.size == 0) return {"variable", v.type, {}, v.cpp, v.verilog};
    return {"element", v.type, {position(v.size)}, v.cpp, v.verilog};
  }
  // A loop variable, a literal below n, or a value.
  Expr position(int n) {
    if (loops_ > 0 && n >= 4 && percent(40)) {
      const std::string i = "i" + std::to_string(below(loops_));
      return {"int", {32, true}, {}, i, i};
    }
    if (percent(30)) return literal(below(n));
    return cast(value(1), {1 + below(3), false});
  }
  static Expr literal(long n) { return {"int", {32, true}, {}, "", "", n}; }
  static Expr cast(const Expr& e, Type t) { return {"cast", t, {e}}; }
  Expr small(const Expr& e, int width) {
    return e.type.width > width ? cast(e, {width, e.type.is_signed}) : e;
  }
  static Type both(Type a, Type b) {
    const bool s = a.is_signed || b.is_signed;
    return {std::max(a.width + (s && !a.is_signed), b.width + (s && !b.is_signed)), s};
  }

  Expr value(int depth) {
    if (depth == 0 || percent(15)) return leaf();
    static const std::vector<std::string> binary{"+", "-",  "*", "/",  "%",  "&",  "|",  "^",
                                                 "<", "<=", ">", ">=", "==", "!=", "&&", "||"};
    Expr a = small(value(depth - 1), 24);
    const int kind = below(28);
    if (kind < 16) {
      const std::string& op = binary[std::size_t(kind)];
      Expr b = percent(15) && kind < 14 ? literal(below(20) - 5) : small(value(depth - 1), 24);
      if (loops_ > 0 && kind < 14 && percent(15)) b = position(4);
      if (kind >= 2 && kind <= 4) {
        a = small(a, 5), b = b.is_int() ? leaf() : small(b, 4);
      }
      const Type t = both(a.type, b.type);
      const int w[] = {t.width + 1, t.width + 1, a.type.width + b.type.width,
                       a.type.width + b.type.is_signed};
      if (kind == 4) return {op, a.type, {a, b}};
      if (kind == 5 && a.type.is_signed != b.type.is_signed)
        return {op, a.type.is_signed ? b.type : a.type, {a, b}};
      if (kind < 8) return {op, {kind < 4 ? w[kind] : t.width, t.is_signed || kind == 1}, {a, b}};
      return {op, {1, false}, {a, b}};
    }
    const Expr b = small(value(depth - 1), 24);
    const Type t = both(a.type, b.type), bit{1, false};
    const int width = a.type.width, low = below(width), n = 1 + below(width - low);
    switch (kind) {
      case 16:
        return {"shl", type(), {a, position(4)}};
      case 17:
        return {">>", a.type, {a, position(8)}};
      case 18:
        return {"mux", t, {value(depth - 1), a, b}};
      case 19:
        forks_ += 1;
        return {"?", type(), {value(depth - 1), a, b}};
      case 20:
        return {"slice", {n, false}, {a}, "", "", low};
      case 21:
        return {"bit", bit, {a, position(10)}};
      case 22:
        return {"bits", {n, false}, {a, position(8)}};
      case 23:
        return {"cat", {width + b.type.width, false}, {a, b}};
      case 24:
        return {percent(50) ? "reduce_xor" : percent(50) ? "reduce_and" : "!", bit, {a}};
      case 25:
        return {"~", a.type, {a}};
      case 26:
        return percent(50) ? Expr{"neg", {width + 1, true}, {a}} : cast(a, type());
      default:
        if (m_.functions.empty()) return a;
        forks_ += 1;
        return {"call", m_.functions[0].result, {a, b}, "f0", "f0"};
    }
  }

  std::vector<Stmt> block(int depth, int count) {
    std::vector<Stmt> all;
    for (int i = 0; i < count; ++i) all.push_back(statement(depth));
    return all;
  }
  Stmt statement(int depth) {
    const int kind = depth == 0 ? 0 : below(11);
    Stmt s{Does::assign};
    if (kind >= 4 && kind <= 6) {
      forks_ += 1;
      s.does = Does::choose, s.value = value(2);
      s.blocks = {block(depth - 1, 1 + below(2)), block(depth - 1, below(3))};
      if (!in_merge_ && percent(20)) s.blocks[0].push_back({Does::leave});
    } else if (kind == 7) {
      const double before = forks_;
      s.does = Does::repeat, s.number = loops_++, s.count = 2 + below(3);
      if (percent(60)) {
        s.count = 2 + below(2), s.value = cast(value(2), {s.count, false});
      }
      s.blocks = {block(std::min(depth - 1, 1), 1 + below(2))};
      if (percent(30)) {
        Stmt stop{Does::stop};
        stop.value = value(1), forks_ += 1;
        s.blocks[0].insert(s.blocks[0].begin() + below(2), stop);
      }
      --loops_;
      forks_ = before + (forks_ - before) * s.count + (s.value.op.empty() ? 0 : 2);
    } else if (kind == 8) {
      s.does = Does::select, s.value = cast(value(2), {2 + below(2), percent(30)});
      forks_ += s.value.type.width;
      for (int i = 0; i < 2 + below(2); ++i) s.blocks.push_back(block(depth - 1, 1));
    } else if (kind == 9 && !in_merge_) {
      const double before = forks_;
      in_merge_ = true;
      s.does = Does::merge, s.blocks = {block(depth - 1, 2)};
      in_merge_ = false;
      forks_ = before;
    } else if (kind == 10) {
      s.does = Does::copy, s.number = below(2);
    } else {
      assignment(s);
    }
    return s;
  }
  void assignment(Stmt& s) {
    std::vector<Variable> to = m_.registers;
    to.insert(to.end(), m_.registers.begin(), m_.registers.end());
    to.insert(to.end(), m_.locals.begin(), m_.locals.end());
    to.insert(to.end(), m_.outputs.begin(), m_.outputs.end());
    s.target = to[std::size_t(below(int(to.size())))];
    const Type t = s.target.type;
    s.value = percent(5) ? literal(below(9) - 2) : value(3);
    s.width = t.width;
    if (s.target.size > 0) {
      s.part = "element", s.args = {position(s.target.size)};
    } else if (percent(30)) {
      s.low = below(t.width), s.width = 1 + below(t.width - s.low);
      s.part = percent(40) ? "slice" : percent(50) ? "bit" : "bits";
      if (s.part == "bit") s.width = 1;
      if (s.part != "slice") s.args = {position(8)};
    }
    static const char* ops[] = {"+", "-", "&", "|", "^"};
    const bool is_output = s.target.cpp[0] == 'o';  // "out.o0"
    if (percent(is_output ? 90 : 45)) s.op = ops[below(5)];
    if (!s.part.empty() && s.value.is_int()) s.op = "";
  }

  std::mt19937 random_;
  Model m_;
  std::vector<Variable> scope_;
  int loops_ = 0;
  bool in_merge_ = false;
  double forks_ = 0;
};

}  // namespace

Model drawn(unsigned seed) {
  for (unsigned more = 0;; ++more) {
    Draw draw(seed + 1'000'003u * more);
    Model model = draw.model();
    if (draw.ways() < 3000) return model;
  }
}

}  // namespace cosim::models
