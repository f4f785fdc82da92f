#include "tb/nets/cells.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "model/core/input_error.h"
#include "tb/nets/words.h"
#include "tb/util/words.h"

namespace cosim::nets {

using enum netlist::Constant;
namespace {

const std::set<std::string_view> bitwise{
    "$and",   "$or",    "$xor",    "$xnor",     "$not",     "$pos",    "$buf",
    "$mux",   "$bwmux", "$_BUF_",  "$_NOT_",    "$_AND_",   "$_NAND_", "$_OR_",
    "$_NOR_", "$_XOR_", "$_XNOR_", "$_ANDNOT_", "$_ORNOT_", "$_MUX_",  "$_NMUX_"};

bool is_bitwise(const Cell& cell) { return cell.is_register() || bitwise.contains(cell.type); }

// A pin that the cell drives.
bool is_driven(const Cell& cell, const std::string& pin) {
  if (cell.is_memory()) return pin == "RD_DATA";
  return pin == "Y" || pin == "Q";
}

// The bits of the address of a read port.
std::vector<int> read_address(const Cell& cell, std::size_t port) {
  const auto width = static_cast<std::ptrdiff_t>(cell.number("ABITS"));
  const auto from = cell.pins.at("RD_ADDR").begin() + static_cast<std::ptrdiff_t>(port) * width;
  return {from, from + width};
}

// The bit of an operand that bit `i` of the result depends on; -1 of none.
std::ptrdiff_t source_of(const Cell& cell, const std::string& pin, std::size_t i) {
  const std::vector<int>& bits = cell.pins.at(pin);
  if (pin == "S" && cell.type != "$bwmux") return 0;
  if (i < bits.size()) return static_cast<std::ptrdiff_t>(i);
  const bool is_signed = (pin == "A" || pin == "B") && cell.flag(pin + "_SIGNED");
  return is_signed ? static_cast<std::ptrdiff_t>(bits.size()) - 1 : -1;
}

}  // namespace

bool is_no_logic(const Cell& cell) {
  static const std::set<std::string_view> others{"$assert",   "$assume",   "$cover",   "$live",
                                                 "$fair",     "$check",    "$print",   "$scopeinfo",
                                                 "$specify2", "$specify3", "$specrule"};
  return others.contains(cell.type);
}

void CellGates::refuse(const Cell& cell, const std::string& why) {
  const std::string place = cell.source.substr(cell.source.rfind('/') + 1);
  throw InputError(place.empty() ? why : place + ": " + why);
}

CellGates::CellGates(const Module& module, Graph& graph, std::function<Bit()> unknown,
                     std::function<Bit()> beyond)
    : graph_(graph), unknown_(std::move(unknown)), beyond_(beyond ? std::move(beyond) : unknown_) {
  for (const Cell& cell : module.cells) {
    if (is_no_logic(cell)) continue;
    for (const auto& [pin, bits] : cell.pins) {
      if (!is_driven(cell, pin)) continue;
      for (std::size_t i = 0; i < bits.size(); ++i) {
        if (bits[i] >= 0) driver_[bits[i]] = {&cell, i};
      }
    }
  }
}

Bit CellGates::leaf(int bit) {
  if (bit == zero) return no;
  if (bit == one) return yes;
  if (bit < 0) return unknown_();
  const auto at = value_.find(bit);
  return at != value_.end() ? at->second : value_[bit] = unknown_();  // nothing drives it
}

Bits CellGates::of(const std::vector<int>& bits) {
  Bits all;
  for (const int bit : bits) all.push_back(of(bit));
  return all;
}

std::vector<int> CellGates::needs(const Place& place) const {
  const Cell& cell = *place.cell;
  std::vector<int> bits;
  if (cell.is_register()) {  // what it is at once
    for (const char* pin : {"ARST", "ALOAD", "SET", "CLR"}) {
      if (!cell.has(pin)) continue;
      const auto& all = cell.pins.at(pin);
      bits.push_back(all[std::min(place.bit, all.size() - 1)]);
    }
    if (cell.has("AD")) bits.push_back(cell.pins.at("AD")[place.bit]);
    return bits;
  }
  if (cell.is_memory()) return read_address(cell, place.bit / cell.number("WIDTH"));
  for (const auto& [pin, all] : cell.pins) {
    if (is_driven(cell, pin)) continue;
    if (!is_bitwise(cell)) {
      bits.insert(bits.end(), all.begin(), all.end());
    } else if (const std::ptrdiff_t at = source_of(cell, pin, place.bit); at >= 0) {
      bits.push_back(all[static_cast<std::size_t>(at)]);
    }
  }
  return bits;
}

// Depth first, without recursion: chains of cells are long.
Bit CellGates::of(int bit) {
  if (is_known(bit)) return leaf(bit);
  std::vector<int> stack{bit};
  std::set<int> open;
  while (!stack.empty()) {
    const int at = stack.back();
    const auto driver = driver_.find(at);
    if (is_known(at) || driver == driver_.end()) {
      leaf(at);
      stack.pop_back();
      continue;
    }
    bool is_ready = true;
    for (const int other : needs(driver->second)) {
      if (is_known(other)) continue;
      if (open.contains(other)) refuse(*driver->second.cell, "a combinational loop");
      is_ready = false;
      stack.push_back(other);
    }
    if (is_ready) {
      evaluate(driver->second);
      open.erase(at);
      stack.pop_back();
    } else {
      open.insert(at);
    }
  }
  return value_.at(bit);
}

void CellGates::evaluate(const Place& place) {
  const Cell& cell = *place.cell;
  if (cell.is_memory()) return read(cell, place.bit / cell.number("WIDTH"));
  const std::vector<int>& out = cell.pins.at(cell.is_register() ? "Q" : "Y");
  if (is_bitwise(cell)) {
    const Bit is = one_bit(place);
    if (out[place.bit] >= 0) value_[out[place.bit]] = is;
    return;
  }
  Bits all = result(cell);
  all.resize(out.size(), no);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i] >= 0) value_[out[i]] = all[i];
  }
}

Bit CellGates::one_bit(const Place& place) {
  const Cell& cell = *place.cell;
  if (cell.is_register()) {
    return asynchronous(cell, place.bit, held_.at(cell.pins.at("Q")[place.bit]));
  }
  const auto pin = [&](const char* name) -> Bit {
    const std::ptrdiff_t at = source_of(cell, name, place.bit);
    return at < 0 ? no : leaf(cell.pins.at(name)[static_cast<std::size_t>(at)]);
  };
  const std::string& t = cell.type;
  const Bit a = pin("A");
  if (t == "$not" || t == "$_NOT_") return !a;
  if (t == "$pos" || t == "$buf" || t == "$_BUF_") return a;
  const Bit b = pin("B");
  if (t == "$and" || t == "$_AND_") return graph_.and_of(a, b);
  if (t == "$or" || t == "$_OR_") return graph_.or_of(a, b);
  if (t == "$xor" || t == "$_XOR_") return graph_.xor_of(a, b);
  if (t == "$xnor" || t == "$_XNOR_") return !graph_.xor_of(a, b);
  if (t == "$_NAND_") return !graph_.and_of(a, b);
  if (t == "$_NOR_") return !graph_.or_of(a, b);
  if (t == "$_ANDNOT_") return graph_.and_of(a, !b);
  if (t == "$_ORNOT_") return graph_.or_of(a, !b);
  const Bit chosen = a == b ? a : graph_.mux(pin("S"), b, a);
  return t == "$_NMUX_" ? !chosen : chosen;
}

// A word of a memory; beyond its end it is x.
void CellGates::read(const Cell& cell, std::size_t port) {
  const std::size_t width = cell.number("WIDTH");
  const Bits is = words_of_memory(cell, of(read_address(cell, port)));
  const std::vector<int>& out = cell.pins.at("RD_DATA");
  for (std::size_t i = 0; i < width; ++i) {
    if (const int bit = out[port * width + i]; bit >= 0) value_[bit] = is[i];
  }
}

Bits CellGates::words_of_memory(const Cell& cell, const Bits& address) {
  std::vector<Bits> level = memories_.at(&cell);
  const std::size_t low = cell.number("OFFSET"), width = cell.number("WIDTH");
  // A tree of multiplexers over the addresses from 0 on; an empty word is beyond the memory.
  level.insert(level.begin(), low, Bits{});
  for (const Bit bit : address) {
    std::vector<Bits> next((level.size() + 1) / 2);
    for (std::size_t i = 0; i < next.size(); ++i) {
      Bits &even = level[2 * i], none;
      Bits& odd = 2 * i + 1 < level.size() ? level[2 * i + 1] : none;
      if (even.empty() && odd.empty()) continue;
      if (even.empty()) even = unknown_word(width);
      if (odd.empty()) odd = unknown_word(width);
      next[i] = chosen(graph_, bit, odd, even);
    }
    level = std::move(next);
  }
  return level.front().empty() ? unknown_word(width) : level.front();
}

// A reset, a load or a set that is no matter of the clock; clear comes before set.
Bit CellGates::asynchronous(const Cell& cell, std::size_t bit, Bit otherwise) {
  const auto active = [&](const char* pin, const char* polarity) {
    const auto& all = cell.pins.at(pin);
    const Bit is = of(all[std::min(bit, all.size() - 1)]);
    return cell.flag(polarity) ? is : !is;
  };
  if (cell.has("ARST")) {
    const std::string& text = cell.parameter("ARST_VALUE");
    const char digit = bit < text.size() ? text[text.size() - 1 - bit] : '0';
    const Bit value = digit == 'x' ? unknown_() : digit == '1' ? yes : no;
    otherwise = graph_.mux(active("ARST", "ARST_POLARITY"), value, otherwise);
  }
  if (cell.has("ALOAD")) {
    otherwise =
        graph_.mux(active("ALOAD", "ALOAD_POLARITY"), of(cell.pins.at("AD")[bit]), otherwise);
  }
  if (cell.has("SET")) otherwise = graph_.or_of(active("SET", "SET_POLARITY"), otherwise);
  if (cell.has("CLR")) {
    otherwise = graph_.and_of(!active("CLR", "CLR_POLARITY"), otherwise);
  }
  return otherwise;
}

Bits CellGates::next(const Cell& cell, bool steps) {
  const auto active = [&](const char* pin, const char* polarity) {
    const Bit is = of(cell.pins.at(pin).front());
    return cell.flag(polarity) ? is : !is;
  };
  const std::vector<int>& q = cell.pins.at("Q");
  Bits all;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Bit had = of(q[i]);
    Bit next = of(cell.pins.at("D")[i]);
    const bool enable_first = cell.starts_with("$sdffce");
    const auto enabled = [&] {
      if (cell.has("EN")) next = graph_.mux(active("EN", "EN_POLARITY"), next, had);
    };
    if (!enable_first) enabled();
    if (cell.has("SRST")) {
      const std::string& text = cell.parameter("SRST_VALUE");
      const char digit = i < text.size() ? text[text.size() - 1 - i] : '0';
      const Bit value = digit == 'x' ? unknown_() : digit == '1' ? yes : no;
      next = graph_.mux(active("SRST", "SRST_POLARITY"), value, next);
    }
    if (enable_first) enabled();
    if (steps && cell.has("CLK")) next = graph_.mux(of(cell.pins.at("CLK").front()), next, had);
    all.push_back(asynchronous(cell, i, next));
  }
  return all;
}

Bits CellGates::word(const Cell& cell, const char* pin) {
  Bits all;
  for (const int bit : cell.pins.at(pin)) all.push_back(leaf(bit));
  return all;
}

Bits CellGates::operand(const Cell& cell, const char* pin, std::size_t width) {
  Bits a = word(cell, pin);
  const bool is_signed = !a.empty() && cell.flag(std::string(pin) + "_SIGNED");
  a.resize(width, is_signed ? a.back() : no);
  return a;
}

Bits CellGates::unknown_word(std::size_t width) {
  Bits all(width);
  for (Bit& bit : all) bit = beyond_();
  return all;
}

}  // namespace cosim::nets
