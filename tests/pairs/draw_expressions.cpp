// Expressions, drawn.
#include <algorithm>

#include "tests/pairs/draw.h"

namespace cosim::pairs {
namespace {

constexpr int widest = 70;

}  // namespace

int Draw::width() {
  const int kind = random_.below(10);
  return kind < 5   ? random_.between(1, 8)
         : kind < 8 ? random_.between(2, 17)
                    : random_.of(std::vector<int>{31, 32, 33, 63, 64, 65, widest});
}

Signal Draw::signal(const std::string& name, Type type) {
  Signal s{name, type, 0, false, true, ""};
  if (random_.percent(15)) s.low = random_.between(1, 9);
  if (random_.percent(10)) s.ascending = true;
  return s;
}

Expr Draw::make(Kind kind, const std::string& op, std::vector<Expr> args) {
  Expr e;
  e.kind = kind;
  e.op = op;
  e.args = std::move(args);
  return e;
}

Expr Draw::leaf() {
  if (random_.percent(22)) {
    if (random_.percent(30))
      return number(random_.percent(70) ? random_.below(9) : random_.below(70));
    return constant(random_.bits(random_.percent(15) ? width() : random_.between(1, 8)),
                    random_.percent(30));
  }
  const Signal& s = random_.of(scope_);
  if (!s.is_vector || s.type.width == 1 || random_.percent(60)) return use(s);
  Expr e = use(s);
  e.kind = Kind::part;
  e.count = random_.percent(30) ? 1 : random_.between(1, s.type.width);
  e.low = random_.between(0, s.type.width - e.count);
  return e;
}

Expr Draw::position(int width, int count) {
  int bits = 0;
  while ((2 << bits) - 1 + count <= width) ++bits;
  if (bits == 0) return constant("0");
  return slice(bits);
}

Expr Draw::slice(int bits) {
  for (int tries = 0; tries < 20; ++tries) {
    const Signal& s = random_.of(scope_);
    if (!s.is_vector || s.type.width < bits) continue;
    Expr e = use(s);
    e.kind = Kind::part;
    e.count = bits;
    e.low = random_.between(0, s.type.width - bits);
    return e;
  }
  return constant(random_.bits(bits));
}

Expr Draw::value(int depth) {
  if (depth <= 0) return leaf();
  const auto sub = [&] { return value(depth - 1 - random_.below(2)); };
  switch (random_.below(15)) {
    case 0:
      return make(Kind::unary, random_.of<std::string>({"~", "-", "+", "~"}), {sub()});
    case 1:
      return make(Kind::unary, random_.of<std::string>({"&", "|", "^", "~&", "~|", "~^", "!"}),
                  {sub()});
    case 2:
    case 3:
      return make(Kind::binary, random_.of<std::string>({"+", "-", "+", "-"}), {sub(), sub()});
    case 4:
      return make(Kind::binary, random_.of<std::string>({"&", "|", "^", "~^"}), {sub(), sub()});
    case 5:
      return make(Kind::compare,
                  random_.of<std::string>({"==", "!=", "<", "<=", ">", ">=", "===", "!=="}),
                  {sub(), sub()});
    case 6:
      return make(Kind::logical, random_.of<std::string>({"&&", "||"}), {sub(), sub()});
    case 7:
    case 8: {
      const int kind = random_.below(10);
      const Expr count = kind < 4   ? number(random_.below(random_.percent(80) ? 9 : 70))
                         : kind < 7 ? slice(random_.between(1, 4))
                         : kind < 9 ? leaf()
                                    : constant(random_.bits(random_.between(30, 40)));
      return make(Kind::shift, random_.of<std::string>({"<<", ">>", ">>>", "<<<"}), {sub(), count});
    }
    case 9:
    case 10:
      return make(Kind::ternary, "", {sub(), sub(), sub()});
    case 11: {
      Expr e = make(Kind::concat, "", {sub(), sub()});
      if (random_.percent(30)) e.args.push_back(sub());
      for (Expr& arg : e.args) unsized(arg);
      return type_of(e).width <= widest ? e : leaf();
    }
    case 12: {
      Expr e = make(Kind::replicate, "", {sub()});
      unsized(e.args[0]);
      e.count = random_.between(1, 4);
      return type_of(e).width <= widest ? e : leaf();
    }
    case 13: {
      if (design_.is_sv && random_.percent(40)) {
        Expr e = make(Kind::size, "", {sub()});
        e.count = width();
        return e;
      }
      return make(Kind::cast, random_.of<std::string>({"$signed", "$unsigned"}), {sub()});
    }
    default: {
      if (!can_call_ || design_.functions.empty() || random_.percent(40)) {
        const Signal& s = random_.of(scope_);
        if (!s.is_vector || s.type.width < 3) return leaf();
        Expr e = use(s);
        e.kind = Kind::indexed;
        e.count = random_.between(1, std::min(4, s.type.width - 1));
        e.args = {position(s.type.width, e.count)};
        return e;
      }
      const Function& f = random_.of(design_.functions);
      Expr e = make(Kind::call, f.result.name, {});
      e.type = f.result.type;
      for (std::size_t i = 0; i < f.arguments.size(); ++i) e.args.push_back(sub());
      return e;
    }
  }
}

void Draw::unsized(Expr& e) {
  if (e.op == "unsized") e.op.clear();
  if (e.kind == Kind::name || e.kind == Kind::constant) return;
  if (e.kind == Kind::unary || e.kind == Kind::binary || e.kind == Kind::ternary ||
      e.kind == Kind::shift) {
    for (Expr& arg : e.args) unsized(arg);
  }
}

Expr Draw::heavy(Type& target) {
  target = {random_.between(2, 8), random_.percent(50)};
  const auto few = [&](bool is_signed) {
    return make(Kind::cast, is_signed ? "$signed" : "$unsigned", {slice(random_.between(2, 5))});
  };
  const bool is_signed = random_.percent(50);
  const int kind = random_.below(4);
  if (kind == 0)
    return make(Kind::binary, "*", {few(is_signed), few(random_.percent(70) == is_signed)});
  if (kind == 1) {
    Expr base = constant(random_.bits(random_.between(2, 4)));
    if (random_.percent(50)) return make(Kind::power, "**", {base, slice(random_.between(1, 3))});
    return make(Kind::power, "**", {few(false), number(random_.below(3))});
  }
  const Expr divisor =
      random_.percent(40) ? constant("01" + random_.bits(2), is_signed) : few(is_signed);
  const Expr quotient =
      make(Kind::binary, random_.of<std::string>({"/", "%"}), {few(is_signed), divisor});
  return make(Kind::ternary, "",
              {make(Kind::compare, "==", {divisor, number(0)}),
               constant(random_.bits(3), is_signed), quotient});
}

}  // namespace cosim::pairs
