#include <algorithm>
#include <bit>
#include <chrono>
#include <utility>

#include "tb/equiv/referee.h"
#include "tb/equiv/stepped.h"
#include "tb/proof/sat.h"
#include "tb/util/interrupt.h"

namespace cosim::equiv {
namespace {

constexpr std::size_t seldom = 4;  // clocks

// A gate, and the value that it hardly has.
struct Target {
  Bit bit;
  std::size_t seen = 0;  ///< on so many clocks
};

// How often each gate is 1 on the clocks of a stimulus, as the netlist runs.
std::vector<std::size_t> ones_of(const Side& side, Stepped& stepped,
                                 const std::vector<RefereeInputs::Row>& rows) {
  for (std::size_t i = 0; i < side.registers.size(); ++i) {
    const Register& reg = side.registers[i];
    stepped.begin(i, reg.any ? 'x' : reg.first ? '1' : '0');
  }
  std::vector<std::size_t> ones(stepped.graph().gates().size());
  for (std::size_t t = 1; t < rows.size(); ++t) {
    stepped.clock(rows[t]);
    for (std::size_t i = 0; i < ones.size(); ++i) ones[i] += stepped.of(nets::gate_bit(i)) & 1U;
  }
  return ones;
}

// Those nearest to what is compared first: what makes them so makes others so that they read.
std::vector<Target> targets_of(const Graph& graph, const std::vector<std::size_t>& ones,
                               std::size_t clocks) {
  std::vector<Target> all;
  for (std::size_t i = ones.size(); i-- > 0;) {
    if (!graph.gates()[i].is_logic()) continue;
    const Bit gate = nets::gate_bit(i);
    if (ones[i] < seldom) all.push_back({gate, ones[i]});
    if (clocks - ones[i] < seldom) all.push_back({!gate, clocks - ones[i]});
  }
  return all;
}

class Patterns {
 public:
  Patterns(const Stepped& stepped, const std::vector<std::size_t>& ones, std::size_t clocks,
           std::chrono::steady_clock::time_point until)
      : graph_(stepped.graph()),
        ones_(ones),
        clocks_(clocks),
        targets_(targets_of(graph_, ones, clocks)),
        sat_([until] {
          return InterruptGuard::signal() != 0 || std::chrono::steady_clock::now() >= until;
        }),
        clauses_(graph_, roots(), sat_) {
    for (const auto& [name, input] : stepped.ports()) port_of_[input] = name;
    for (std::size_t i = 0; i < stepped.states().size(); ++i) state_of_[stepped.states()[i]] = i;
  }

  std::vector<RarePattern> made(std::size_t most) {
    std::vector<RarePattern> all;
    constexpr std::size_t attempts = 500;
    std::size_t tried = 0;
    for (std::size_t i = 0; i < targets_.size() && all.size() < most && tried < attempts; ++i) {
      if (targets_[i].seen >= seldom) continue;
      ++tried;
      const proof::Answer answer = sat_.solve({clauses_.of(targets_[i].bit)});
      if (answer == proof::Answer::timed_out) break;
      if (answer == proof::Answer::sat) all.push_back(pattern(targets_[i].bit));
    }
    InterruptGuard::check();
    return all;
  }

 private:
  Bits roots() const {
    Bits all;
    for (const Target& target : targets_) all.push_back(target.bit);
    return all;
  }

  // The share of the clocks on which it holds.
  double chance(Bit bit) const {
    const auto ones = static_cast<double>(ones_[bit.gate()]), all = static_cast<double>(clocks_);
    return (bit.is_inverted() ? all - ones : ones) / all;
  }

  // The inputs that make the target so, where all are as the solver says (justification). What
  // comes by chance beside what is rare is left to chance, as long as both come often enough.
  std::vector<bool> needed(Bit target, const std::vector<std::uint64_t>& gates) const {
    constexpr double rare = 1.0 / 16, least = 1.0 / 8;
    double left = 1;
    std::vector<bool> is_needed(gates.size());
    const auto need = [&](Bit bit) { is_needed[bit.gate()] = true; };
    need(target);
    for (std::size_t i = gates.size(); i-- > 0;) {
      const Graph::Made& gate = graph_.gates()[i];
      if (!is_needed[i] || !gate.is_logic()) continue;
      const auto as_it_is = [&](Bit bit) { return nets::in_runs(gates, bit) != 0 ? bit : !bit; };
      const Bit a = as_it_is(gate.a), b = as_it_is(gate.b);
      const bool a_is_rarer = chance(a) < chance(b);
      const Bit rarer = a_is_rarer ? a : b, other = a_is_rarer ? b : a;
      if (gate.kind == nets::Gate::mux) {
        need(a);
        need(nets::in_runs(gates, gate.a) != 0 ? gate.b : gate.c);
      } else if (gate.kind == nets::Gate::xor_gate) {
        need(a);
        need(b);
      } else if (gates[i] == 0) {  // one that is 0 is enough
        const bool is_by_other = other == !(a_is_rarer ? gate.b : gate.a);
        need(is_by_other ? other : rarer);
      } else {
        need(rarer);
        if (chance(rarer) < rare && left * chance(other) >= least) {
          left *= chance(other);
        } else {
          need(other);
        }
      }
    }
    return is_needed;
  }

  // What it takes for the target; what else it makes so is seen, too.
  RarePattern pattern(Bit target) {
    std::vector<Stepped::Values> runs;
    for (const bool value : clauses_.inputs()) runs.push_back(value ? ~Stepped::Values{0} : 0);
    const std::vector<bool> is_needed = needed(target, nets::run(graph_, runs));
    RarePattern made;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const char digit = runs[i] != 0 ? '1' : '0';
      if (!is_needed[graph_.inputs()[i].gate()]) {
        runs[i] = random_.next();
      } else if (const auto port = port_of_.find(i); port != port_of_.end()) {
        made.inputs.emplace_back(port->second, digit);
      } else if (const auto state = state_of_.find(i); state != state_of_.end()) {
        made.state.emplace(state->second, digit);
      }
    }
    const std::vector<std::uint64_t> gates = nets::run(graph_, runs);
    constexpr int often = 8;  // of 64 runs
    for (Target& one : targets_) {
      if (std::popcount(nets::in_runs(gates, one.bit)) >= often) ++one.seen;
      if (one.bit == target) one.seen = seldom;
    }
    return made;
  }

  const Graph& graph_;
  const std::vector<std::size_t>& ones_;
  std::size_t clocks_;
  std::vector<Target> targets_;
  proof::Sat sat_;
  proof::Clauses clauses_;
  std::map<std::size_t, Name> port_of_;          // by input of the graph
  std::map<std::size_t, std::size_t> state_of_;  // registers
  Random random_ = Random::for_case(1665343, 0);
};

}  // namespace

std::vector<RarePattern> rare_patterns(const Side& side, const Referee& how,
                                       const std::vector<RefereeInputs::Row>& rows) {
  constexpr std::size_t most = 64;
  constexpr std::chrono::milliseconds share(500);
  Stepped stepped(side, !side.memories.empty() && side.is_cut(), how.steps);
  const std::vector<std::size_t> ones = ones_of(side, stepped, rows);
  const auto until = std::min(how.until, std::chrono::steady_clock::now() + share);
  return Patterns(stepped, ones, rows.size() - 1, until).made(most);
}

}  // namespace cosim::equiv
