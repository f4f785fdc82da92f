// The clocks of the reset are written out from any state, with the reset at a level and all other
// inputs at any value. Constants are carried through the gates (symbolic simulation): the registers
// that are constant then are those that the reset gives a value.
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

#include "tb/equiv/clocks.h"
#include "tb/util/pattern.h"

namespace cosim::equiv {
namespace {

using Resets = std::map<std::string, bool>;

// Of the registers of both, the old ones first.
std::vector<bool> left_constant(const Question& q, const Resets& held) {
  std::vector<bool> constant;
  for (const Side* side : {&q.gold, &q.gate}) {
    Graph graph;
    const auto any = [&](std::size_t count) {
      Bits lits(count);
      for (Bit& lit : lits) lit = graph.input();
      return lits;
    };
    const auto input = [&](const Name& name) -> Bit {
      const std::string port = side == &q.gate ? gold_name(q, name.first) : name.first;
      if (const auto tied = tied_bit(q, {port, name.second})) return *tied ? yes : no;
      if (const auto at = held.find(port); at != held.end()) return at->second ? yes : no;
      return q.steps && side->clocks.contains(name.first) ? yes : graph.input();
    };
    Bits state = any(side->registers.size());
    for (int i = 0; i < q.reset_clocks; ++i) {
      state = side->make(graph, input, any(side->unknowns), state).next;
    }
    for (const Bit lit : state) constant.push_back(lit.is_constant());
  }
  return constant;
}

// Whether a name is of that form, in small or in capital letters.
bool is_called(std::string name, const Pattern& form) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return form.in(name);
}

struct Found {
  std::string pin;
  bool level = true;
  std::size_t registers = 0;
};

// The pin and its level that give the most registers a constant that nothing else gives. Of levels
// that give as many it is the one that the name says.
Found best_of(const Question& q, const std::vector<std::string>& pins, const Resets& known) {
  static const Pattern low("(_|rst|reset|clr|clear)n(_?i)?$|^n_?(rst|reset|clr|clear)");
  const std::vector<bool> given = left_constant(q, known);
  Found best;
  for (const std::string& pin : pins) {
    const bool named = !is_called(pin, low);
    for (const bool level : {named, !named}) {
      Resets held = known;
      held[pin] = level;
      const std::vector<bool> constant = left_constant(q, held);
      std::size_t more = 0;
      for (std::size_t i = 0; i < given.size(); ++i) more += constant[i] && !given[i] ? 1U : 0U;
      if (best.pin.empty() || more > best.registers) best = {pin, level, more};
    }
  }
  return best;
}

Resets found_in(const Question& q) {
  static const Pattern name("rst|reset|clr|clear");
  Resets found = q.gold.asynchronous_resets;
  for (const auto& [pin, level] : q.gate.asynchronous_resets) {
    found.try_emplace(gold_name(q, pin), level);
  }
  std::erase_if(found, [&](const auto& one) { return q.tied.contains(one.first); });
  if (!found.empty() && !q.steps) return found;
  std::vector<std::string> pins;
  for (const auto& [port, width] : q.gold.inputs) {
    const bool taken =
        q.gold.clocks.contains(port) || q.tied.contains(port) || found.contains(port);
    if (width == 1 && !taken && is_called(port, name)) pins.push_back(port);
  }
  while (!pins.empty()) {
    const Found best = best_of(q, pins, found);
    if (best.registers == 0) break;
    found[best.pin] = best.level;
    if (!q.steps) break;
    std::erase(pins, best.pin);
  }
  return found;
}

}  // namespace

void find_resets(Question& q) {
  if (q.resets) return;
  Resets found;
  for (const auto& [pin, level] : q.wanted_resets) {
    found[pin] = level ? *level : best_of(q, {pin}, {}).level;
  }
  if (q.wanted_resets.empty() && q.reset_clocks > 0) found = found_in(q);
  if (found.empty()) q.reset_clocks = 0;
  q.resets = found;
}

}  // namespace cosim::equiv
