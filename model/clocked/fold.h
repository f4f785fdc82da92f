// The value of a node of a graph, where those that it is made of are known.
#pragma once

#include "model/clocked/words.h"

namespace cosim::clocked {

using Id = std::uint32_t;

/// A node: its operation on other nodes, its width, and what else it says: of a slice its lowest
/// bit is b, of a constant or an input its number is a.
struct Node {
  Op op = Op::constant;
  int width = 0;
  Id a = 0, b = 0, c = 0;
  bool operator==(const Node&) const = default;
};

constexpr int operands(Op op) {
  if (op <= Op::input) return 0;
  if (op == Op::ite) return 3;
  return op == Op::bnot || op >= Op::slice ? 1 : 2;
}

/// The result of a node from codes of its operands, 0 where there is none; wa and wb are their
/// widths. R is a number without a sign that has room for all of them. As BTOR2 has it.
template <class R>
constexpr R folded(const Node& n, int wa, int wb, const R& a, const R& b, const R& c) {
  const auto ones = [](int width) { return static_cast<R>(~(~R(0) << (width - 1) << 1)); };
  const auto is_set = [](const R& x, int i) { return (x >> i & R(1)) != R(0); };
  const auto negated = [](const R& x) { return static_cast<R>(R(0) - x); };
  const auto to_count = [&](const R& x) {
    return x < R(std::uint64_t(n.width)) ? int(resized<std::uint64_t, false>(x)) : n.width;
  };
  const R mask = ones(n.width);
  const auto kept = [&](const R& x) { return static_cast<R>(x & mask); };
  const auto left = [&](const R& x, int by) {
    return by >= n.width ? R(0) : kept(static_cast<R>(x << by));
  };
  const auto right = [&](const R& x, int by) {
    return by >= n.width ? R(0) : static_cast<R>(x >> by);
  };
  const bool minus_a = wa > 0 && is_set(a, wa - 1), minus_b = wb > 0 && is_set(b, wb - 1);
  const auto size = [&](const R& x, bool minus) { return minus ? kept(negated(x)) : x; };
  switch (n.op) {
    case Op::bnot:
      return a ^ mask;
    case Op::add:
      return kept(a + b);
    case Op::sub:
      return kept(a - b);
    case Op::mul:
      return kept(a * b);
    case Op::udiv:
      return b == R(0) ? mask : static_cast<R>(a / b);
    case Op::urem:
      return b == R(0) ? a : static_cast<R>(a % b);
    case Op::sdiv: {
      const R x = size(a, minus_a), y = size(b, minus_b);
      const R r = y == R(0) ? mask : static_cast<R>(x / y);
      return minus_a != minus_b ? kept(negated(r)) : r;
    }
    case Op::srem: {
      const R x = size(a, minus_a), y = size(b, minus_b);
      const R r = y == R(0) ? x : static_cast<R>(x % y);
      return minus_a ? kept(negated(r)) : r;
    }
    case Op::band:
      return a & b;
    case Op::bor:
      return a | b;
    case Op::bxor:
      return a ^ b;
    case Op::sll:
      return left(a, to_count(b));
    case Op::srl:
      return right(a, to_count(b));
    case Op::sra: {
      const R r = right(a, to_count(b));
      return minus_a ? static_cast<R>(r | (mask ^ right(mask, to_count(b)))) : r;
    }
    case Op::eq:
      return R(a == b);
    case Op::ult:
      return R(a < b);
    case Op::slt:
      return R(minus_a != minus_b ? minus_a : a < b);
    case Op::ite:
      return a != R(0) ? b : c;
    case Op::concat:
      return static_cast<R>(left(a, wb) | b);
    case Op::slice:
      return kept(static_cast<R>(a >> int(n.b)));
    case Op::uext:
      return a;
    case Op::sext:
      return minus_a ? static_cast<R>(a | (mask ^ ones(wa))) : a;
    default:
      return R(0);
  }
}

}  // namespace cosim::clocked
