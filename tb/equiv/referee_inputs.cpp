#include "tb/equiv/referee.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <set>

#include "tb/equiv/sources.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"

namespace cosim::equiv {
namespace {

// The binary digits of a number that is written as 32'hdead_beef: its width, base and digits.
// Nothing where it has more than 64 bits.
std::string digits_of(const std::string& width, char base, std::string number) {
  std::erase(number, '_');
  const bool is_short = width.size() < 3 && number.size() <= (base == 'b' ? 64U : 16U);
  const unsigned long size = is_short ? std::stoul(width) : 0;
  if (size == 0 || size > 64) return "";
  char* end = nullptr;
  const int radix = base == 'b' ? 2 : base == 'o' ? 8 : base == 'd' ? 10 : 16;
  const std::uint64_t value = std::strtoull(number.c_str(), &end, radix);
  std::string digits;
  for (std::size_t i = size; *end == '\0' && i-- > 0;) digits += (value >> i & 1U) != 0 ? '1' : '0';
  return digits;
}

}  // namespace

RefereeInputs::RefereeInputs(const Side& side, const Referee& how)
    : side_(side), how_(how), random_(Random::for_case(1989, 0)) {
  find_compared();
  find_written();
}

// Of each comparison with a constant, the bits that are inputs. A word of none, which may be an
// input some clocks ago, stands for each input of its width.
void RefereeInputs::find_compared() {
  static const std::set<std::string> comparisons{"$eq", "$ne", "$eqx", "$nex"};
  std::map<int, Name> inputs;
  for (const Port& port : side_.module().ports) {
    for (std::size_t i = 0; port.way == "input" && i < port.bits.size(); ++i) {
      inputs[port.bits[i]] = {port.name, static_cast<int>(i)};
    }
  }
  for (const Cell& cell : side_.module().cells) {
    if (!comparisons.contains(cell.type)) continue;
    for (const auto& [word, constant] : {std::pair("A", "B"), std::pair("B", "A")}) {
      const std::vector<int>&bits = cell.pins.at(word), &values = cell.pins.at(constant);
      const auto is_constant = [](int bit) { return bit == zero || bit == one; };
      if (!std::ranges::all_of(values, is_constant)) continue;
      const auto digit = [&](std::size_t i) {
        return i < values.size() && values[i] == one ? '1' : '0';
      };
      Compared own;
      for (std::size_t i = 0; i < bits.size(); ++i) {
        if (const auto at = inputs.find(bits[i]); at != inputs.end()) {
          own.emplace_back(at->second, digit(i));
        }
      }
      for (const auto& [port, width] : side_.inputs) {
        if (!own.empty() || width == 1 || static_cast<std::size_t>(width) != bits.size()) continue;
        Compared& all = compared_.emplace_back();
        for (int i = 0; i < width; ++i) {
          all.emplace_back(Name(port, i), digit(static_cast<std::size_t>(i)));
        }
      }
      if (own.size() > 1) compared_.push_back(std::move(own));
    }
  }
}

// Numbers of the source, for inputs of their width: what a front end leaves out has no comparison
// in the netlist.
void RefereeInputs::find_written() {
  static const rtl::Regex number("\\b([0-9]+)\\s*'[sS]?([bBoOdDhH])\\s*([0-9a-fA-F_]+)");
  constexpr std::size_t most = 200;
  std::set<std::string> all;  // digits, the highest bit first
  for (const SourceText& source : sources_of(side_.files())) {
    const std::string plain = rtl::blanked(source.text);
    for (const rtl::Match& found : number.all(plain)) {
      const char base = static_cast<char>(std::tolower(found[2].front()));
      const std::string digits = digits_of(found[1], base, found[3]);
      if (digits.size() > 4 && all.size() < most) all.insert(digits);
    }
  }
  for (const std::string& digits : all) {
    for (const auto& [port, width] : side_.inputs) {
      if (static_cast<std::size_t>(width) != digits.size()) continue;
      Compared& own = compared_.emplace_back();
      for (int i = 0; i < width; ++i)
        own.emplace_back(Name(port, i), digits[std::size_t(width - 1 - i)]);
    }
  }
}

RefereeInputs::Row RefereeInputs::row(std::size_t clock) {
  constexpr std::size_t stretch = 24;
  if (clock % stretch == 0) {
    for (const auto& [port, width] : side_.inputs) ways_[port] = random_.below(8);
  }
  Row row;
  for (const auto& [port, width] : side_.inputs) {
    if (!how_.steps && side_.clocks.contains(port)) continue;
    row[port] = digits(port, static_cast<std::size_t>(width), row);
  }
  if (!compared_.empty() && random_.below(3) == 0) {
    for (std::uint64_t many = 1 + random_.below(3); many > 0; --many) {
      for (const auto& [bit, digit] : compared_[random_.below(compared_.size())]) {
        const auto word = row.find(bit.first);  // a clock has none
        if (word == row.end()) continue;
        word->second[word->second.size() - 1 - static_cast<std::size_t>(bit.second)] = digit;
      }
    }
  }
  // The reset first, and now and then.
  constexpr std::size_t first = 3;
  constexpr std::uint64_t seldom = 60;
  const bool resets = clock < first || random_.below(seldom) == 0;
  for (const auto& [port, level] : how_.resets) {
    row[port] = (resets && (clock < first || random_.below(2) == 0)) == level ? "1" : "0";
  }
  before_ = row;
  return row;
}

std::string RefereeInputs::digits(const std::string& port, std::size_t width, const Row& row) {
  const std::uint64_t way = ways_[port];
  std::string text(width, '0');
  if (width == 1) {
    constexpr std::uint64_t eighths[] = {1, 4, 7, 4, 4, 6, 2, 4};
    text[0] = random_.below(8) < eighths[way] ? '1' : '0';
    return text;
  }
  const std::uint64_t kind = random_.below(12) + way;
  if (kind >= 15 && before_.contains(port)) return before_.at(port);
  if (kind == 14) {
    for (const auto& [other, value] : row) {
      if (value.size() == width) return value;
    }
  }
  if (kind >= 11) {  // a small number, or one below the highest
    const std::uint64_t small = random_.below(std::uint64_t{1} << random_.below(7));
    const char fill = random_.below(4) == 0 ? '1' : '0';
    for (std::size_t i = 0; i < width; ++i) {
      const bool bit = i < 64 && (small >> i & 1U) != 0;
      text[width - 1 - i] = bit ? (fill == '1' ? '0' : '1') : fill;
    }
    return text;
  }
  if (kind == 10) {  // the ends of the ranges
    const std::uint64_t end = random_.below(5);
    std::fill(text.begin(), text.end(), end == 1 || end == 2 ? '1' : '0');
    if (end >= 2) text.front() = end == 2 ? '0' : '1';
    if (end == 4) text[random_.below(width)] = '1';
    return text;
  }
  const std::uint64_t sparse = way == 1 ? 6 : way == 2 ? 2 : 4;
  for (char& bit : text) bit = random_.below(8) < sparse ? '1' : '0';
  return text;
}

}  // namespace cosim::equiv
