#include <algorithm>

#include "tb/equiv/referee.h"
#include "tb/equiv/testbench.h"
#include "tb/util/random.h"

namespace cosim::equiv {
namespace {

using Rows = std::vector<RefereeInputs::Row>;

void add_row(Stimulus& s, Rows& rows, RefereeInputs::Row row) {
  std::string text;
  for (const std::string& port : s.inputs) text += row.at(port);
  s.rows.push_back(text);
  rows.push_back(std::move(row));
}

void give(const RarePattern& pattern, RefereeInputs::Row& row) {
  for (const auto& [bit, digit] : pattern.inputs) {
    const auto word = row.find(bit.first);  // a clock has none, nor has a memory
    if (word == row.end()) continue;
    word->second[word->second.size() - 1 - static_cast<std::size_t>(bit.second)] = digit;
  }
}

// So many of them, each several times where there are fewer; none where there are none.
std::vector<RarePattern> repeated(const std::vector<RarePattern>& patterns, std::size_t many) {
  std::vector<RarePattern> all;
  while (!patterns.empty() && all.size() < many)
    all.push_back(patterns[all.size() % patterns.size()]);
  return all;
}

// No register is reset at once while it is loaded, nor on the clock before.
void add_loads(const Side& side, std::size_t times, const std::vector<RarePattern>& patterns,
               Stimulus& s, Rows& rows, RefereeInputs& inputs) {
  load_states(side, times, patterns, s);
  s.first_load = s.rows.size() - 1;
  for (std::size_t t = 0; t < s.states.size() * load_clocks; ++t) {
    RefereeInputs::Row row = inputs.row(s.first_load + t);
    const std::size_t rare = s.states.size() - patterns.size(), load = t / load_clocks;
    if (load >= rare) give(patterns[load - rare], row);
    for (const auto& [port, level] : side.asynchronous_resets) {
      const bool is_near = t % load_clocks == 0 || t % load_clocks == load_clocks - 1;
      if (is_near && row.contains(port)) row[port] = level ? "0" : "1";
    }
    add_row(s, rows, std::move(row));
  }
}

}  // namespace

Stimulus referee_stimulus(const Side& side, const Referee& how, Simulator simulator,
                          std::size_t gates, Rows& rows) {
  constexpr std::size_t most = 2048, least = 128, work = 60'000'000;
  const std::size_t clocks = std::clamp(work / (gates + 1), least, most);
  Stimulus s;
  s.steps = how.steps;
  for (const auto& [port, width] : side.inputs) {
    if (how.steps || !side.clocks.contains(port)) s.inputs.push_back(port);
  }
  for (const auto& [port, width] : side.outputs) s.outputs.push_back(port);
  RefereeInputs inputs(side, how);
  s.rows.push_back(at_rest(side, s));
  rows.emplace_back();
  for (std::size_t t = 0; t < clocks; ++t) add_row(s, rows, inputs.row(t));
  // Each register is given a value, as far as names go.
  Random random = Random::for_case(1631518, 1665343);
  std::string begins;
  for (std::size_t i = 0; i < side.registers.size(); ++i) {
    begins += random.below(2) == 0 ? '0' : '1';
  }
  constexpr std::size_t most_bits = 6000;
  std::size_t bits = 0;
  for (Variable& one : variables_of(side, begins)) {
    bits += side.outputs.empty() ? 1 : std::max<std::size_t>(one.value.size(), 1);
    if (bits > most_bits) break;
    s.variables.push_back(std::move(one));
  }
  // Those of inputs alone come by themselves, on several clocks each; the others need a state.
  constexpr std::size_t share = 32;
  const std::size_t times = clocks / share;
  std::vector<RarePattern> of_inputs, of_states;
  for (RarePattern& one : rare_patterns(side, how, rows)) {
    (one.state.empty() ? of_inputs : of_states).push_back(std::move(one));
  }
  for (const RarePattern& one : repeated(of_inputs, times)) {
    for (std::size_t i = 0; i < load_clocks; ++i) {
      RefereeInputs::Row row = inputs.row(rows.size() - 1);
      give(one, row);
      add_row(s, rows, std::move(row));
    }
  }
  if (simulator == Simulator::icarus) {
    add_loads(side, times, repeated(of_states, times), s, rows, inputs);
  }
  return s;
}

}  // namespace cosim::equiv
