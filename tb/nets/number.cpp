#include "tb/nets/number.h"

#include <algorithm>

namespace cosim::nets {
namespace {

constexpr int kWord = 64;
constexpr int kShiftBits = 6;  // of a shift by less than a word

// That of the one which has one.
template <class A, class B>
Graph& graph_of(const A& a, const B& b) {
  return a.graph() != nullptr ? *a.graph() : *b.graph();
}

int longer(const Number& a, const Number& b) { return std::max(a.width(), b.width()); }

// -v: its code turned over, and the other carry.
Number::Open turned(Number::Open v) {
  for (Bit& bit : v.bits) bit = !bit;
  v.carry = !v.carry;
  return v;
}

// a + b.
Number sum(Graph& graph, const Number& a, const Number::Open& b) {
  const int width = std::max(a.width(), static_cast<int>(b.bits.size())) + 1;
  std::vector<Bit> bits;
  Bit carry = b.carry;
  for (int i = 0; i < std::min(width, kWord); ++i) {
    const Bit x = a.at(i), y = b.at(i), odd = graph.xor_of(x, y);
    bits.push_back(graph.xor_of(odd, carry));
    carry = graph.mux(odd, carry, x);
  }
  return Number::signed_code(graph, std::move(bits));
}

template <class Of>
std::vector<Bit> bits_of(int width, Of of) {
  std::vector<Bit> bits;
  for (int i = 0; i < width; ++i) bits.push_back(of(i));
  return bits;
}
template <class Of>
Number bit_by_bit(Graph& graph, int width, Of of) {
  return Number::signed_code(graph, bits_of(width, of));
}

// Whether a number is none of 0 .. 63.
Truth is_out(const Number& n) {
  Truth out = false;
  for (int i = kShiftBits; i < std::max(n.width(), kShiftBits + 1); ++i) out = out | bit(n, i);
  return out;
}

}  // namespace

Truth operator!(const Truth& a) {
  return a.known() ? Truth(!*a.known()) : Truth(*a.graph(), !a.bit());
}
Truth operator&(const Truth& a, const Truth& b) {
  if (a.known()) return *a.known() ? b : a;
  if (b.known()) return *b.known() ? a : b;
  return {*a.graph(), a.graph()->and_of(a.bit(), b.bit())};
}
Truth operator|(const Truth& a, const Truth& b) { return !(!a & !b); }
Truth operator^(const Truth& a, const Truth& b) {
  if (a.known()) return *a.known() ? !b : b;
  if (b.known()) return *b.known() ? !a : a;
  return {*a.graph(), a.graph()->xor_of(a.bit(), b.bit())};
}

Number::Number(Graph* graph, std::vector<Bit> bits) : graph_(graph), bits_(std::move(bits)) {
  if (bits_.size() > kWord) bits_.resize(kWord);
  while (bits_.size() > 1 && bits_.back() == bits_[bits_.size() - 2]) bits_.pop_back();
}
Number::Number(Word known)
    : Number(nullptr, bits_of(kWord, [&](int i) { return cosim::bit(known, i) ? yes : no; })) {}
Number::Number(const Truth& t) : Number(select(t, Number(1), Number(0))) {}
Number Number::unsigned_code(Graph& graph, std::vector<Bit> code) {
  code.push_back(no);  // beyond a word it is cut off again
  return {&graph, std::move(code)};
}
Number Number::signed_code(Graph& graph, std::vector<Bit> code) {
  return {&graph, std::move(code)};
}

Bit Number::at(int i) const {
  return i < width() ? bits_[static_cast<std::size_t>(i)] : bits_.back();
}

Bit Number::Open::at(int i) const {
  return bits[std::min(static_cast<std::size_t>(i), bits.size() - 1)];
}
Number Number::with_open(Open open) && {
  open_ = std::move(open);
  return std::move(*this);
}

std::vector<Bit> Number::code(int width) const {
  return bits_of(width, [&](int i) { return at(i); });
}

std::optional<Word> Number::known() const {
  if (!std::ranges::all_of(bits_, [](Bit b) { return b.is_constant(); })) return std::nullopt;
  std::uint64_t word = 0;
  for (int i = 0; i < kWord; ++i) word |= std::uint64_t{at(i) == yes} << i;
  return static_cast<Word>(word);
}

Number operator+(const Number& a, const Number& b) {
  if (a.known() && b.known()) return Number(cosim::add(*a.known(), *b.known()));
  return b.has_open() ? sum(graph_of(a, b), a, b.open()) : sum(graph_of(a, b), b, a.open());
}
Number operator-(const Number& a, const Number& b) {
  if (a.known() && b.known()) return Number(cosim::subtract(*a.known(), *b.known()));
  Number difference = sum(graph_of(a, b), a, turned(b.open()));
  return a.known() == 0 ? std::move(difference).with_open(turned(b.open())) : difference;
}
// The last bit of a two's complement code counts less than nothing.
Number operator*(const Number& a, const Number& b) {
  if (a.known() && b.known()) return Number(cosim::multiply(*a.known(), *b.known()));
  if (a.known()) return b * a;
  Number product(0);
  for (int i = 0; i < b.width(); ++i) {
    const Number term = select(bit(b, i), shift_left(a, i), Number(0));
    product = i + 1 < b.width() ? product + term : product - term;
  }
  return product;
}

Number operator&(const Number& a, const Number& b) {
  if (a.known() && b.known()) return Number(*a.known() & *b.known());
  Graph& graph = graph_of(a, b);
  return bit_by_bit(graph, longer(a, b), [&](int i) { return graph.and_of(a.at(i), b.at(i)); });
}
Number operator|(const Number& a, const Number& b) {
  if (a.known() && b.known()) return Number(*a.known() | *b.known());
  Graph& graph = graph_of(a, b);
  return bit_by_bit(graph, longer(a, b), [&](int i) { return graph.or_of(a.at(i), b.at(i)); });
}
Number operator^(const Number& a, const Number& b) {
  if (a.known() && b.known()) return Number(*a.known() ^ *b.known());
  Graph& graph = graph_of(a, b);
  return bit_by_bit(graph, longer(a, b), [&](int i) { return graph.xor_of(a.at(i), b.at(i)); });
}

// Of the highest bits that differ, and of signs the other way round.
Truth operator<(const Number& a, const Number& b) {
  if (a.known() && b.known()) return *a.known() < *b.known();
  Graph& graph = graph_of(a, b);
  Bit less = no;
  const int sign = longer(a, b) - 1;
  for (int i = 0; i <= sign; ++i) {
    const Bit one = i == sign ? a.at(i) : b.at(i);
    less = graph.mux(graph.xor_of(a.at(i), b.at(i)), one, less);
  }
  return {graph, less};
}
Truth operator>(const Number& a, const Number& b) { return b < a; }
Truth operator==(const Number& a, const Number& b) {
  if (a.known() && b.known()) return *a.known() == *b.known();
  Graph& graph = graph_of(a, b);
  Bit same = yes;
  for (int i = 0; i < longer(a, b); ++i) same = graph.and_of(same, !graph.xor_of(a.at(i), b.at(i)));
  return {graph, same};
}

Number low_bits(const Number& v, int width) {
  if (v.known()) return Number(cosim::low_bits(*v.known(), width));
  return Number::unsigned_code(*v.graph(), v.code(width));
}
Truth bit(const Number& v, int i) {
  if (v.known()) return cosim::bit(*v.known(), i);
  return {*v.graph(), v.at(i)};
}
Number shift_left(const Number& v, int n) {
  if (v.known()) return Number(cosim::shift_left(*v.known(), n));
  const auto up = [n](const auto& code, Bit below) {
    return [&code, below, n](int i) { return i < n ? below : code.at(i - n); };
  };
  Number shifted = bit_by_bit(*v.graph(), v.width() + n, up(v, no));
  if (!v.has_open()) return shifted;
  // Below are as many ones as carry it to its place.
  const Number::Open open = v.open();
  const int width = static_cast<int>(open.bits.size()) + n;
  return std::move(shifted).with_open({bits_of(width, up(open, open.carry)), open.carry});
}
Number shift_right(const Number& v, int n) {
  if (v.known()) return Number(cosim::shift_right(*v.known(), n));
  return bit_by_bit(*v.graph(), std::max(v.width() - n, 1), [&](int i) { return v.at(i + n); });
}
Number shift_left(const Number& v, const Number& n) {
  Number shifted = v;
  for (int i = 0; i < kShiftBits; ++i) {
    shifted = select(bit(n, i), shift_left(shifted, 1 << i), shifted);
  }
  return select(is_out(n), Number(0), shifted);
}
Number shift_right(const Number& v, const Number& n) {
  Number shifted = v;
  for (int i = 0; i < kShiftBits; ++i) {
    shifted = select(bit(n, i), shift_right(shifted, 1 << i), shifted);
  }
  return select(is_out(n), shift_right(v, kWord - 1), shifted);
}
Number select(const Truth& c, const Number& a, const Number& b) {
  if (c.known()) return *c.known() ? a : b;
  Graph& graph = *c.graph();
  const auto one_of = [&](const auto& x, const auto& y) {
    return [&](int i) { return graph.mux(c.bit(), x.at(i), y.at(i)); };
  };
  Number chosen = bit_by_bit(graph, longer(a, b), one_of(a, b));
  if (!a.has_open() && !b.has_open()) return chosen;
  const Number::Open x = a.open(), y = b.open();
  const int width = static_cast<int>(std::max(x.bits.size(), y.bits.size()));
  return std::move(chosen).with_open(
      {bits_of(width, one_of(x, y)), graph.mux(c.bit(), x.carry, y.carry)});
}

}  // namespace cosim::nets
