// What cells do to words.
#include <fmt/core.h>

#include <algorithm>

#include "tb/nets/cells.h"
#include "tb/nets/words.h"
#include "tb/util/words.h"

namespace cosim::nets {

using enum netlist::Constant;
namespace {

Bit parity(Graph& graph, const Bits& a) {
  Bit odd = no;
  for (const Bit bit : a) odd = graph.xor_of(odd, bit);
  return odd;
}
Bits negated(Graph& graph, const Bits& a) { return difference(graph, Bits(a.size(), no), a); }

}  // namespace

Bit CellGates::any(const Bits& a) { return graph_.differ(a, Bits(a.size(), no)); }

Bits CellGates::result(const Cell& cell) {
  const std::string& t = cell.type;
  if (!cell.has("Y") || !cell.has("A")) refuse(cell, "an unknown cell: " + one_line(t));
  const std::size_t width = cell.pins.at("Y").size();
  if (t == "$reduce_and") return {graph_.all_of(word(cell, "A"))};
  if (t == "$reduce_or" || t == "$reduce_bool") return {any(word(cell, "A"))};
  if (t == "$reduce_xor") return {parity(graph_, word(cell, "A"))};
  if (t == "$reduce_xnor") return {!parity(graph_, word(cell, "A"))};
  if (t == "$logic_not") return {!any(word(cell, "A"))};
  if (t == "$neg") return negated(graph_, operand(cell, "A", width));
  if (t == "$tribuf") refuse(cell, "a tri-state net");
  if (t == "$slice") {
    const Bits a = word(cell, "A");
    const auto low = static_cast<std::ptrdiff_t>(cell.number("OFFSET"));
    return {a.begin() + low, a.begin() + low + static_cast<std::ptrdiff_t>(width)};
  }
  if (t == "$pmux" || t == "$bmux" || t == "$demux" || t == "$lut") return selected(cell, width);
  if (!cell.has("B")) refuse(cell, "an unknown cell: " + one_line(t));
  if (t == "$concat") {
    Bits all = word(cell, "A");
    const Bits high = word(cell, "B");
    all.insert(all.end(), high.begin(), high.end());
    return all;
  }
  if (t == "$logic_and" || t == "$logic_or") {
    const Bit a = any(word(cell, "A")), b = any(word(cell, "B"));
    return {t == "$logic_and" ? graph_.and_of(a, b) : graph_.or_of(a, b)};
  }
  if (t == "$add") return sum(graph_, operand(cell, "A", width), operand(cell, "B", width));
  if (t == "$sub") return difference(graph_, operand(cell, "A", width), operand(cell, "B", width));
  if (t == "$mul") return product(graph_, operand(cell, "A", width), operand(cell, "B", width));
  if (t == "$div" || t == "$mod" || t == "$divfloor" || t == "$modfloor") {
    return quotient(cell, width);
  }
  if (t == "$pow") return power(cell, width);
  if (cell.starts_with("$sh") || cell.starts_with("$ssh")) return shifted(cell, width);
  return {compared(cell)};
}

Bits CellGates::quotient(const Cell& cell, std::size_t width) {
  const std::size_t wide =
      std::max({width, cell.pins.at("A").size(), cell.pins.at("B").size()}) + 1;
  const bool is_signed = cell.flag("A_SIGNED") && cell.flag("B_SIGNED");
  const Bits a = operand(cell, "A", wide), b = operand(cell, "B", wide);
  const auto both = is_signed ? divided_with_sign(graph_, a, b) : divided(graph_, a, b);
  Bits is = cell.starts_with("$div") ? both.quotient : both.remainder;
  if (is_signed && cell.type.ends_with("floor")) {
    const Bit apart = graph_.xor_of(a.back(), b.back());
    const Bit rounds = graph_.and_of(apart, any(both.remainder));
    is = sum(
        graph_, is,
        cell.starts_with("$div") ? Bits(wide, rounds) : chosen(graph_, rounds, b, Bits(wide, no)));
  }
  is.resize(width);
  const Bit is_zero = !any(b);
  return is_zero == no ? is : chosen(graph_, is_zero, unknown_word(width), is);
}

// By repeated squaring. A negative exponent leaves 1 or -1 of these, x of 0, and 0 of all else.
Bits CellGates::power(const Cell& cell, std::size_t width) {
  Bits base = operand(cell, "A", width);
  const Bits exponent = word(cell, "B");
  Bits is(width, no);
  is.front() = yes;
  const Bits one_word = is;
  const Bit negative = cell.flag("B_SIGNED") ? exponent.back() : no;
  const Bits a = word(cell, "A");
  for (std::size_t i = 0; i < exponent.size(); ++i) {
    is = chosen(graph_, exponent[i], product(graph_, is, base), is);
    if (i + 1 < exponent.size()) base = product(graph_, base, base);
  }
  if (negative == no) return is;
  const Bit is_zero = !any(a);
  const Bit is_one = equal(graph_, a, resized({yes}, a.size(), no));
  const Bit is_minus = cell.flag("A_SIGNED") ? graph_.all_of(a) : no;
  Bits below = chosen(graph_, is_one, one_word, Bits(width, no));
  below =
      chosen(graph_, is_minus, chosen(graph_, exponent.front(), Bits(width, yes), one_word), below);
  below = chosen(graph_, is_zero, unknown_word(width), below);
  return chosen(graph_, negative, below, is);
}

Bits CellGates::shifted(const Cell& cell, std::size_t width) {
  const std::string& t = cell.type;
  const Bits b = word(cell, "B");
  const std::size_t wide = std::max(width, cell.pins.at("A").size());
  Bits a = operand(cell, "A", wide);
  if (t == "$shl" || t == "$sshl") {
    a = shifted_up(graph_, std::move(a), b);
  } else if (t == "$shr" || t == "$sshr") {
    a = shifted_down(graph_, a, b, t == "$sshr" && cell.flag("A_SIGNED") ? a.back() : no);
  } else if (t == "$shift" || t == "$shiftx") {
    // Of $shiftx each bit from beyond the word is x: one value for all of them, as far as they can
    // be seen together.
    const bool fills_x = t == "$shiftx";
    if (fills_x) a = word(cell, "A");
    const auto moved = [&](const Bits& of) {
      const Bits down = shifted_down(graph_, of, b, no);
      if (!cell.flag("B_SIGNED")) return down;
      return chosen(graph_, b.back(), shifted_up(graph_, of, negated(graph_, b)), down);
    };
    const std::size_t had = a.size();
    a.resize(wide, no);
    Bits result = moved(a);
    result.resize(width);
    if (!fills_x) return result;
    Bits within(wide, no);
    std::fill_n(within.begin(), had, yes);
    within = moved(within);
    for (std::size_t i = 0; i < width; ++i) {
      if (within[i] != yes) result[i] = graph_.mux(within[i], result[i], beyond_());
    }
    return result;
  } else {
    refuse(cell, "an unknown cell: " + one_line(t));
  }
  a.resize(width);
  return a;
}

Bit CellGates::case_equal(const Cell& cell) {
  const std::vector<int>&a = cell.pins.at("A"), &b = cell.pins.at("B");
  const std::size_t width = std::max(a.size(), b.size());
  const bool is_signed = cell.flag("A_SIGNED") && cell.flag("B_SIGNED");
  const auto bit = [&](const std::vector<int>& bits, std::size_t i) -> int {
    return i < bits.size() ? bits[i] : is_signed ? bits.back() : zero;
  };
  const auto is_open = [](int at) { return at == is_x || at == is_z; };
  Bit same = yes;
  for (std::size_t i = 0; i < width; ++i) {
    const int x = bit(a, i), y = bit(b, i);
    if (is_open(x) || is_open(y)) {
      if (x != y) return no;
    } else {
      same = graph_.and_of(same, !graph_.xor_of(leaf(x), leaf(y)));
    }
  }
  return same;
}

Bit CellGates::compared(const Cell& cell) {
  const std::string& t = cell.type;
  // What compares the items of a `case` is of this name.
  const bool is_case = cell.name.find("$procmux$") != std::string::npos &&
                       cell.name.find("_CMP") != std::string::npos;
  if (t == "$eqx" || (t == "$eq" && is_case)) return case_equal(cell);
  if (t == "$nex") return !case_equal(cell);
  const std::size_t width = std::max(cell.pins.at("A").size(), cell.pins.at("B").size());
  const bool is_signed = cell.flag("A_SIGNED") && cell.flag("B_SIGNED");
  const Bits a = operand(cell, "A", width), b = operand(cell, "B", width);
  if (t == "$eq") return equal(graph_, a, b);
  if (t == "$ne") return !equal(graph_, a, b);
  if (t == "$lt") return less(graph_, a, b, is_signed);
  if (t == "$ge") return !less(graph_, a, b, is_signed);
  if (t == "$gt") return less(graph_, b, a, is_signed);
  if (t == "$le") return !less(graph_, b, a, is_signed);
  refuse(cell, "an unknown cell: " + one_line(t));
}

Bits CellGates::selected(const Cell& cell, std::size_t width) {
  const std::string& t = cell.type;
  const Bits a = word(cell, "A");
  const auto part = [&](const Bits& of, std::size_t i) {
    const auto low = static_cast<std::ptrdiff_t>(i * width);
    return Bits(of.begin() + low, of.begin() + low + static_cast<std::ptrdiff_t>(width));
  };
  if (t == "$pmux") {
    // The first item of a `case` that fits is the last word.
    const Bits b = word(cell, "B"), s = word(cell, "S");
    Bits is = a;
    for (std::size_t i = 0; i < s.size(); ++i) is = chosen(graph_, s[i], part(b, i), is);
    return is;
  }
  if (t == "$demux") {
    const Bits s = word(cell, "S");
    Bits is;
    for (std::size_t i = 0; i * a.size() < width; ++i) {
      Bit here = yes;
      for (std::size_t bit = 0; bit < s.size(); ++bit) {
        here = graph_.and_of(here, (i >> bit & 1U) != 0 ? s[bit] : !s[bit]);
      }
      for (const Bit bit : a) is.push_back(graph_.and_of(here, bit));
    }
    return is;
  }
  // A table, or words, of which the bits of S choose; those of a table are a parameter.
  const Bits s = t == "$lut" ? a : word(cell, "S");
  Bits table = a;
  if (t == "$lut") {
    const std::string& text = cell.parameter("LUT");
    table.assign(std::size_t{1} << s.size(), no);
    for (std::size_t i = 0; i < table.size() && i < text.size(); ++i) {
      const char digit = text[text.size() - 1 - i];
      table[i] = digit == '1' ? yes : digit == '0' ? no : unknown_();
    }
  }
  for (const Bit bit : s) {
    Bits half;
    for (std::size_t i = 0; 2 * i * width < table.size(); ++i) {
      const Bits pair = chosen(graph_, bit, part(table, 2 * i + 1), part(table, 2 * i));
      half.insert(half.end(), pair.begin(), pair.end());
    }
    table = std::move(half);
  }
  return table;
}

}  // namespace cosim::nets
