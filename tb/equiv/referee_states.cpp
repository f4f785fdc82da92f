#include <algorithm>
#include <map>
#include <set>

#include "tb/equiv/referee.h"
#include "tb/equiv/sources.h"
#include "tb/util/random.h"

namespace cosim::equiv {
namespace {

bool is_told_of_states(const Side& side) {
  const std::vector<SourceText> sources = sources_of(side.files());
  return !place_of(sources, "\\b(unique0?|priority)\\b").empty() ||
         std::ranges::any_of(sources, [](const SourceText& one) {
           return one.text.find("parallel_case") != std::string::npos ||
                  one.text.find("full_case") != std::string::npos;
         });
}

// Whether another net than an input resets a register at once.
bool has_inner_reset(const Side& side) {
  std::set<int> inputs{zero, one};
  for (const Port& port : side.module().ports) {
    if (port.way == "input") inputs.insert(port.bits.begin(), port.bits.end());
  }
  return std::ranges::any_of(side.module().cells, [&](const Cell& cell) {
    return std::ranges::any_of(
        std::initializer_list<const char*>{"ARST", "ALOAD"}, [&](const char* pin) {
          return cell.has(pin) && !inputs.contains(cell.pins.at(pin).front());
        });
  });
}

// The constants of comparisons, the highest bit first.
std::vector<std::string> constants_of(const Module& module) {
  static const std::set<std::string> comparisons{"$eq", "$ne", "$eqx", "$nex",
                                                 "$lt", "$le", "$gt",  "$ge"};
  std::set<std::string> all;
  for (const Cell& cell : module.cells) {
    if (!comparisons.contains(cell.type)) continue;
    for (const char* pin : {"A", "B"}) {
      std::string text;
      for (const int bit : cell.pins.at(pin)) text += bit == one ? '1' : bit == zero ? '0' : 'x';
      std::ranges::reverse(text);
      if (text.find('x') == std::string::npos) all.insert(text);
    }
  }
  return {all.begin(), all.end()};
}

// The number above or below, as far as it has so many digits.
void step(std::string& digits, bool up) {
  for (auto at = digits.rbegin(); at != digits.rend(); ++at) {
    const bool was_one = *at == '1';
    *at = was_one ? '0' : '1';
    if (was_one != up) break;
  }
}

std::string value(std::size_t width, const std::vector<std::string>& constants, Random& random) {
  std::string text(width, '0');
  switch (random.below(4)) {
    case 0: {
      const std::uint64_t small = random.below(std::uint64_t{1} << random.below(6));
      for (std::size_t i = 0; i < width && i < 64; ++i) {
        text[width - 1 - i] = (small >> i & 1U) != 0 ? '1' : '0';
      }
      return text;
    }
    case 1:
      break;
    default:
      if (constants.empty()) break;
      const std::string& constant = constants[random.below(constants.size())];
      for (std::size_t i = 0; i < width && i < constant.size(); ++i) {
        text[width - 1 - i] = constant[constant.size() - 1 - i];
      }
      if (const std::uint64_t by = random.below(6); by < 2) step(text, by == 0);
      return text;
  }
  for (char& bit : text) bit = random.below(2) == 0 ? '0' : '1';
  return text;
}

}  // namespace

void load_states(const Side& side, std::size_t times, const std::vector<RarePattern>& patterns,
                 Stimulus& s) {
  if (s.variables.empty() || has_inner_reset(side) || is_told_of_states(side)) return;
  const std::vector<std::string> constants = constants_of(side.module());
  Random random = Random::for_case(1631518, 4);
  std::map<std::string, const std::vector<std::size_t>*> registers_of;
  for (const auto& [name, registers] : side.variables) registers_of[name] = &registers;
  std::size_t at = 0;
  for (Variable& one : s.variables) {
    one.at = at;
    at += one.width;
  }
  for (std::size_t i = 0; i < times + patterns.size(); ++i) {
    std::string& state = s.states.emplace_back();
    std::map<std::size_t, char> digits;  // a register may have several names
    if (i >= times) digits = patterns[i - times].state;
    for (const Variable& one : s.variables) {
      std::string text = value(one.width, constants, random);
      const std::vector<std::size_t>& registers = *registers_of.at(one.name);
      for (std::size_t r = 0; r < registers.size(); ++r) {
        char& digit = text[one.width - 1 - r];
        digit = digits.try_emplace(registers[r], digit).first->second;
      }
      state += text;
    }
  }
}

}  // namespace cosim::equiv
