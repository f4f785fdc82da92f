#include "tests/pairs/design.h"

#include <algorithm>

namespace cosim::pairs {

std::string Random::bits(int width) {
  std::string all;
  // Corners as often as other values.
  const int style = below(5);
  for (int i = 0; i < width; ++i) {
    const bool is_low = i + 3 >= width;
    all += style == 0 || (style == 1 && !is_low) ? '0' : style == 2 ? '1' : percent(50) ? '1' : '0';
  }
  return all;
}

Type common(Type a, Type b) { return {std::max(a.width, b.width), a.is_signed && b.is_signed}; }

Type type_of(const Expr& e) {
  const auto of = [&](std::size_t i) { return type_of(e.args[i]); };
  switch (e.kind) {
    case Kind::constant:
    case Kind::name:
    case Kind::word:
    case Kind::call:
      return e.type;
    case Kind::part:
    case Kind::indexed:
      return {e.count, false};
    case Kind::unary:
      return e.op == "~" || e.op == "-" || e.op == "+" ? of(0) : Type{};
    case Kind::binary:
      return common(of(0), of(1));
    case Kind::compare:
    case Kind::logical:
      return {};
    case Kind::shift:
    case Kind::power:
      // Their right operand has no say, but for the sign of a power.
      return {of(0).width, of(0).is_signed && (e.kind == Kind::shift || of(1).is_signed)};
    case Kind::ternary:
      return common(of(1), of(2));
    case Kind::concat: {
      Type sum{0, false};
      for (const Expr& arg : e.args) sum.width += type_of(arg).width;
      return sum;
    }
    case Kind::replicate:
      return {e.count * of(0).width, false};
    case Kind::cast:
      return {of(0).width, e.op == "$signed"};
    case Kind::size:
      return {e.count, of(0).is_signed};
  }
  return {};
}

Expr constant(const std::string& bits, bool is_signed) {
  Expr e;
  e.bits = bits;
  e.type = {static_cast<int>(bits.size()), is_signed};
  return e;
}

Expr number(int value) {
  std::string bits;
  for (int i = 31; i >= 0; --i) bits += (value >> i & 1) != 0 ? '1' : '0';
  Expr e = constant(bits, true);
  e.op = "unsized";
  return e;
}

Expr use(const Signal& signal) {
  Expr e;
  e.kind = Kind::name;
  e.op = signal.name;
  e.type = signal.type;
  return e;
}

}  // namespace cosim::pairs
