// What symbols are: nodes of a graph of words, each node in it once. Exporter alone.
#pragma once

#include <algorithm>
#include <bit>
#include <deque>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/clocked/fold.h"

namespace cosim::clocked {

class Graph {
 public:
  /// A node by its number; its operands have lower ones. 0 is none.
  const Node& operator[](Id id) const { return nodes_[id]; }
  std::size_t size() const { return nodes_.size() - 1; }
  int width(Id id) const { return nodes_[id].width; }
  /// The value of a constant, else null.
  const Wide* known(Id id) const {
    return nodes_[id].op == Op::constant ? &values_[nodes_[id].a] : nullptr;
  }

  /// Is called at each 65,536th node that is made, new or not.
  void (*watch)() = nullptr;

  Id input(int width) { return intern({Op::input, width, inputs_++}); }
  /// The constant of the lower `width` bits of value.
  Id constant(int width, const Wide& value) {
    const Wide kept = value & ~(~Wide(0) << width);
    const auto [place, is_new] = constants_.try_emplace({width, kept}, 0);
    if (is_new) {
      values_.push_back(kept);
      place->second = intern({Op::constant, width, Id(values_.size() - 1)});
    }
    return place->second;
  }
  Id constant(int width, std::uint64_t value) { return constant(width, Wide(value)); }
  /// One of this width, as simple as it is known to be.
  Id make(Op op, int width, Id a, Id b = 0) {
    if (++made_ % watched == 0 && watch != nullptr) watch();
    if (is_commutative(op) && (known(a) != nullptr || (known(b) == nullptr && b < a)))
      std::swap(a, b);
    const Node n{op, width, a, b};
    if (const Id simple = simplified(n)) return simple;
    return intern(n);
  }
  Id ite(Id c, Id yes, Id no);
  Id bnot(Id a) { return make(Op::bnot, width(a), a); }
  Id is_not_zero(Id a) {
    return width(a) == 1 ? a : bnot(make(Op::eq, 1, a, constant(width(a), 0)));
  }
  Id slice(Id a, int low, int count);
  /// a with more bits in front, as of a number with a sign where is_signed, or its lower ones.
  Id resized(Id a, bool is_signed, int to) {
    if (to <= width(a)) return slice(a, 0, to);
    return make(is_signed ? Op::sext : Op::uext, to, a);
  }

 private:
  static constexpr std::uint64_t watched = 65'536;
  static bool is_commutative(Op op) {
    return op == Op::add || op == Op::mul || op == Op::band || op == Op::bor || op == Op::bxor ||
           op == Op::eq;
  }
  bool is(Id id, Op op) const { return id != 0 && nodes_[id].op == op; }
  bool is_zero(Id id) const { return is(id, Op::constant) && *known(id) == Wide(0); }
  bool is_ones(Id id) const {
    return is(id, Op::constant) && (*known(id) | ~Wide(0) << width(id)) == ~Wide(0);
  }
  Id intern(const Node& n) {
    const auto [place, is_new] = ids_.try_emplace(n, Id(nodes_.size()));
    if (is_new) nodes_.push_back(n);
    return place->second;
  }
  /// The bits that a needs as a number without a sign, or with one.
  int needed(Id a, bool is_signed) const;
  Id made_slice(Id a, int low, int count);
  Id simplified(const Node& n);
  Id simpler_compare(const Node& n);

  struct Hash {
    std::size_t operator()(const Node& n) const {
      std::size_t h = std::size_t(n.op) << 16 | std::size_t(n.width);
      for (const Id x : {n.a, n.b, n.c}) h = (h ^ x) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
      return h;
    }
  };
  std::vector<Node> nodes_{1};
  std::deque<Wide> values_;
  std::unordered_map<Node, Id, Hash> ids_;
  std::unordered_map<Node, Id, Hash> slices_;
  std::map<std::pair<int, Wide>, Id> constants_;
  Id inputs_ = 0;
  std::uint64_t made_ = 0;
};

inline Graph graph;

inline Id Graph::simplified(const Node& n) {
  const Id a = n.a, b = n.b;
  const int w = n.width;
  const bool is_binary = operands(n.op) == 2;
  if (n.op == Op::slice) return 0;
  if (known(a) != nullptr && (!is_binary || known(b) != nullptr)) {
    const Wide& y = is_binary ? *known(b) : *known(a);
    return constant(w, folded<Wide>(n, width(a), width(b), *known(a), y, Wide()));
  }
  switch (n.op) {
    case Op::bnot:
      return is(a, Op::bnot) ? nodes_[a].a : 0;
    case Op::add:
      return is_zero(b) ? a : 0;
    case Op::sub:
      return is_zero(b) ? a : a == b ? constant(w, 0) : 0;
    case Op::mul:
      return is_zero(b) ? b : is(b, Op::constant) && *known(b) == Wide(1) ? a : 0;
    case Op::band:
      if (is(b, Op::bnot) && nodes_[b].a == a) return constant(w, 0);
      return is_zero(b) || is_ones(a) ? b : is_ones(b) || a == b ? a : 0;
    case Op::bor:
      if (is(b, Op::bnot) && nodes_[b].a == a) return constant(w, ~Wide(0));
      return is_ones(b) ? b : is_zero(b) || a == b ? a : 0;
    case Op::bxor:
      return is_zero(b) ? a : is_ones(b) ? bnot(a) : a == b ? constant(w, 0) : 0;
    case Op::sll:
    case Op::srl:
    case Op::sra: {
      if (known(b) == nullptr) return 0;
      const int by = *known(b) < Wide(std::uint64_t(w)) ? int((*known(b))[0]) : w;
      if (by == 0) return a;
      if (n.op == Op::sra)
        return resized(slice(a, std::min(by, w - 1), w - std::min(by, w - 1)), true, w);
      if (by == w) return constant(w, 0);
      if (n.op == Op::srl) return resized(slice(a, by, w - by), false, w);
      return make(Op::concat, w, slice(a, 0, w - by), constant(by, 0));
    }
    case Op::eq:
    case Op::ult:
    case Op::slt:
      return simpler_compare(n);
    case Op::concat:
      if (is_zero(a)) return resized(b, false, w);
      if (is(a, Op::slice) && is(b, Op::slice) && nodes_[a].a == nodes_[b].a &&
          int(nodes_[a].b) == int(nodes_[b].b) + width(b)) {
        return slice(nodes_[a].a, int(nodes_[b].b), w);
      }
      return 0;
    case Op::uext:
    case Op::sext:
      if (width(a) == w) return a;
      if (is(a, Op::uext)) return resized(nodes_[a].a, false, w);
      return is(a, n.op) ? resized(nodes_[a].a, n.op == Op::sext, w) : 0;
    default:
      return 0;
  }
}

inline int Graph::needed(Id a, bool is_signed) const {
  const Node& n = nodes_[a];
  if (n.op == Op::uext) return width(n.a) + is_signed;
  if (n.op == Op::sext && is_signed) return width(n.a);
  if (n.op != Op::constant) return n.width;
  const Wide& v = values_[n.a];
  const bool minus = is_signed && (v >> (n.width - 1) & Wide(1)) != Wide(0);
  const Wide rest = minus ? ~v & ~(~Wide(0) << n.width) : v;
  int top = (n.width - 1) / 64;
  while (top > 0 && rest[top] == 0) --top;
  return std::max(1, 64 * top + int(std::bit_width(rest[top])) + is_signed);
}

// A comparison of as few bits as its numbers need.
inline Id Graph::simpler_compare(const Node& n) {
  const int w = width(n.a);
  if (n.a == n.b) return constant(1, n.op == Op::eq);
  if (n.op == Op::eq && w == 1 && known(n.b) != nullptr) return is_zero(n.b) ? bnot(n.a) : n.a;
  const auto at = [&](Op op, int to) { return make(op, 1, slice(n.a, 0, to), slice(n.b, 0, to)); };
  const int plain = std::max(needed(n.a, false), needed(n.b, false));
  const int with_sign = std::max(needed(n.a, true), needed(n.b, true));
  if (n.op != Op::slt && plain < w) return at(n.op, plain);
  if (n.op == Op::slt && plain < w && plain < with_sign) return at(Op::ult, plain);
  if (n.op != Op::ult && with_sign < w) return at(n.op, with_sign);
  if (n.op == Op::ult && is_zero(n.b)) return constant(1, 0);
  return 0;
}

inline Id Graph::slice(Id a, int low, int count) {
  if (low == 0 && count == width(a)) return a;
  if (const Wide* value = known(a)) return constant(count, *value >> low);
  // Kept, for ways from node to node are many more than nodes.
  const Node asked{Op::slice, count, a, Id(low)};
  if (const auto kept = slices_.find(asked); kept != slices_.end()) return kept->second;
  return slices_[asked] = made_slice(a, low, count);
}

inline Id Graph::made_slice(Id a, int low, int count) {
  const Node n = nodes_[a];
  const auto piece = [&](Id x) { return slice(x, low, count); };
  switch (n.op) {
    case Op::slice:
      return slice(n.a, int(n.b) + low, count);
    case Op::concat:
      if (low >= width(n.b)) return slice(n.a, low - width(n.b), count);
      if (low + count <= width(n.b)) return slice(n.b, low, count);
      return make(Op::concat, count, slice(n.a, 0, low + count - width(n.b)),
                  slice(n.b, low, width(n.b) - low));
    case Op::uext:
    case Op::sext:
      if (low + count <= width(n.a)) return piece(n.a);
      if (low < width(n.a))
        return resized(slice(n.a, low, width(n.a) - low), n.op == Op::sext, count);
      if (n.op == Op::uext) return constant(count, 0);
      return resized(slice(n.a, width(n.a) - 1, 1), true, count);
    case Op::bnot:
      return bnot(piece(n.a));
    case Op::band:
    case Op::bor:
    case Op::bxor:
      return make(n.op, count, piece(n.a), piece(n.b));
    case Op::ite:
      return ite(n.a, piece(n.b), piece(n.c));
    case Op::add:
    case Op::sub:
    case Op::mul:  // lower bits are of lower bits alone
      if (low == 0) return make(n.op, count, piece(n.a), piece(n.b));
      if (low + count < n.width) return slice(slice(a, 0, low + count), low, count);
      break;
    default:
      break;
  }
  return intern({Op::slice, count, a, Id(low)});
}

inline Id Graph::ite(Id c, Id yes, Id no) {
  if (const Wide* value = known(c)) return *value == Wide(0) ? no : yes;
  if (is(c, Op::bnot)) return ite(nodes_[c].a, no, yes);
  if (is(yes, Op::ite) && nodes_[yes].a == c) yes = nodes_[yes].b;
  if (is(no, Op::ite) && nodes_[no].a == c) no = nodes_[no].c;
  if (yes == no) return yes;
  if (width(yes) == 1) {
    if (is_ones(yes) || yes == c) return make(Op::bor, 1, c, no);
    if (is_zero(no) || no == c) return make(Op::band, 1, c, yes);
    if (is_zero(yes)) return make(Op::band, 1, bnot(c), no);
    if (is_ones(no)) return make(Op::bor, 1, bnot(c), yes);
  }
  return intern({Op::ite, width(yes), c, yes, no});
}

}  // namespace cosim::clocked
