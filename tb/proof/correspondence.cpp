// Signal correspondence (van Eijk). Runs by chance say what may be the same; a SAT solver is asked
// for a state in which all of it is so, and a clock that leads out of it; what that tells apart is
// cut, until there is none. In both clocks a node is replaced by what it is equal to as soon as it
// has been compared with it (speculative reduction): where anything differs, the first node that
// does so, in the order of the nodes, is seen to, since all that it reads is what it should be.
#include "tb/proof/correspondence.h"

#include <algorithm>
#include <map>
#include <utility>

#include "tb/proof/chance.h"
#include "tb/proof/sat.h"
#include "tb/util/random.h"

namespace cosim::proof {
namespace {

using nets::Bit;
using nets::Bits;
using nets::gate_bit;
using nets::no;
using nets::yes;
using Runs = std::uint64_t;  // a bit each

class Refinement {
 public:
  Refinement(const nets::Graph& graph, Bit bad, std::chrono::steady_clock::time_point until)
      : graph_(graph), until_(until) {
    begin(bad);
  }

  std::optional<Same> found() {
    for (const bool is_step : {false, true}) {
      for (Answer answer = Answer::sat; answer != Answer::unsat;) {
        answer = is_step ? step() : first();
        if (answer != Answer::sat && answer != Answer::unsat) return std::nullopt;
      }
    }
    return same();
  }

 private:
  // Literals that may be equal, in the order of their nodes.
  using Class = Bits;

  // Those that no run by chance tells apart, by a hash of what they were.
  void begin(Bit bad) {
    constexpr std::size_t most = 4000, steps = 20'000'000;
    constexpr Runs factor = 0x9e3779b97f4a7c15ULL;
    const std::size_t nodes = graph_.gates().size();
    const std::vector<bool> is_in = graph_.cone(Bits{no, bad}, true);
    std::vector<Runs> hash(nodes), turned(nodes);
    bool is_first = true;
    run_by_chance(graph_, 0, std::min(most, steps / nodes + 1), [&](const nets::Runs& runs) {
      for (std::size_t n = 0; n < nodes; ++n) {
        const Runs is = runs.of(gate_bit(n));
        if (is_first) turned[n] = 0 - (is & 1U);
        hash[n] = ((hash[n] ^ is ^ turned[n]) * factor) ^ (hash[n] >> 29U);
      }
      is_first = false;
      return std::chrono::steady_clock::now() < until_;
    });
    std::map<Runs, Class> classes;
    for (std::size_t n = 0; n < nodes; ++n) {
      if (!is_in[n]) continue;
      Class& its = classes[hash[n]];
      // An input is equal to nothing before it.
      if (graph_.gates()[n].kind == nets::Gate::input && !its.empty()) continue;
      its.push_back(gate_bit(n) ^ ((turned[n] & 1U) != 0));
    }
    for (auto& [key, its] : classes) {
      if (its.size() > 1) classes_.push_back(std::move(its));
    }
  }

  Same same() const {
    Same same(graph_.gates().size());
    for (std::size_t n = 0; n < same.size(); ++n) same[n] = gate_bit(n);
    for (const Class& its : classes_) {
      for (const Bit lit : its) same[lit.gate()] = its.front() ^ lit.is_inverted();
    }
    return same;
  }

  // From the first state.
  Answer first() {
    nets::Graph logic;
    Bits state;
    for (const nets::Graph::Latch& latch : graph_.latches())
      state.push_back(nets::constant(latch.first));
    const Frame now = frame_of(
        graph_, same(), logic, [&](std::size_t) { return logic.input(); }, &state);
    const Satisfied found = satisfy(logic, {}, now.differ, until_);
    if (found.answer != Answer::sat) return found.answer;
    nets::Runs tried(logic), runs(graph_);
    tried.clock(varied(found.inputs, found.inputs.size()));
    runs.clock(inputs(tried, now));
    return cut(runs, ~Runs{0});
  }

  // From a state in which all is so.
  Answer step() {
    nets::Graph logic;
    const auto leaf = [&](std::size_t) { return logic.input(); };
    const Frame was = frame_of(graph_, same(), logic, leaf);
    const std::size_t given = logic.inputs().size();
    const Bits state = next_state(graph_, was);
    const Frame now = frame_of(graph_, same(), logic, leaf, &state);
    Bits all;
    for (const Bit lit : was.differ) all.push_back(!lit);
    const Satisfied found = satisfy(logic, all, now.differ, until_);
    if (found.answer != Answer::sat) return found.answer;
    nets::Runs tried(logic), runs(graph_);
    tried.clock(varied(found.inputs, given));
    Runs are_so = ~Runs{0};
    for (const Bit lit : all) are_so &= tried.of(lit);
    if ((are_so & 1U) == 0) return Answer::failed;
    std::vector<Runs> begun;
    for (const nets::Graph::Latch& latch : graph_.latches()) {
      begun.push_back(tried.of(was.values[latch.now.gate()]));
    }
    runs.begin(std::move(begun));
    runs.clock(inputs(tried, was));
    runs.clock(inputs(tried, now));
    return cut(runs, are_so);
  }

  // These inputs in the first run; in others some are changed, rarely the first `given`, so that
  // more is told apart at a time.
  std::vector<Runs> varied(const std::vector<bool>& row, std::size_t given) {
    constexpr Runs others = ~Runs{0} << 16U;
    std::vector<Runs> inputs;
    for (const bool bit : row) {
      Runs changed = random_.next();
      if (inputs.size() < given) {
        for (int i = 0; i < 4; ++i) changed &= random_.next();
        changed &= others;
      }
      inputs.push_back((bit ? ~Runs{0} : 0) ^ (changed & ~Runs{1}));
    }
    return inputs;
  }

  std::vector<Runs> inputs(const nets::Runs& tried, const Frame& frame) const {
    std::vector<Runs> all;
    for (std::size_t n = 0; n < graph_.gates().size(); ++n) {
      if (graph_.gates()[n].kind == nets::Gate::input) all.push_back(tried.of(frame.values[n]));
    }
    return all;
  }

  // Cuts the classes by what they are in those runs, and on the clocks after it as long as that
  // cuts any: what is left is so on each of them, so that the next one is as good. Failed where
  // nothing is cut.
  Answer cut(nets::Runs& runs, Runs those) {
    constexpr int idle = 8;
    bool any = false;
    for (int left = idle; left > 0; --left) {
      if (cut_once(runs, those)) {
        any = true;
        left = idle;
      }
      std::vector<Runs> inputs(graph_.inputs().size());
      for (Runs& one : inputs) one = random_.next();
      runs.clock(inputs);
    }
    return any ? Answer::sat : Answer::failed;
  }

  bool cut_once(const nets::Runs& runs, Runs those) {
    std::vector<Class> cut;
    bool is_cut = false;
    for (Class& its : classes_) {
      const Runs value = runs.of(its.front()) & those;
      const auto is_same = [&](Bit lit) { return (runs.of(lit) & those) == value; };
      if (std::all_of(its.begin(), its.end(), is_same)) {
        cut.push_back(std::move(its));
        continue;
      }
      is_cut = true;
      std::map<Runs, Class> parts;
      for (const Bit lit : its) parts[runs.of(lit) & those].push_back(lit);
      for (auto& [own, part] : parts) {
        if (part.size() > 1) cut.push_back(std::move(part));
      }
    }
    classes_ = std::move(cut);
    return is_cut;
  }

  const nets::Graph& graph_;
  std::chrono::steady_clock::time_point until_;
  std::vector<Class> classes_;
  Random random_{0};
};

}  // namespace

Frame frame_of(const nets::Graph& graph, const Same& same, nets::Graph& to,
               const std::function<Bit(std::size_t)>& leaf, const Bits* state) {
  const auto& nodes = graph.gates();
  Frame frame{Bits(nodes.size()), {}};
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const bool is_merged = same[n].gate() != n;
    const bool is_latch = nodes[n].kind == nets::Gate::latch;
    Bit own = no;
    if (nodes[n].is_logic()) own = remade(to, nodes[n], frame.values);
    if (is_latch && state != nullptr) own = (*state)[nodes[n].number];
    if (nodes[n].kind == nets::Gate::input || (is_latch && state == nullptr && !is_merged)) {
      own = leaf(n);
    }
    frame.values[n] = is_merged ? placed_at(frame.values, same[n]) : own;
    if (!is_merged || (is_latch && state == nullptr)) continue;
    const Bit differs = to.xor_of(own, frame.values[n]);
    if (differs != no) frame.differ.push_back(differs);
  }
  return frame;
}

Bits next_state(const nets::Graph& graph, const Frame& frame) {
  Bits state;
  for (const nets::Graph::Latch& latch : graph.latches()) {
    state.push_back(placed_at(frame.values, latch.next));
  }
  return state;
}

std::optional<Same> corresponding(const nets::Graph& graph, Bit bad,
                                  std::chrono::steady_clock::time_point until) {
  return Refinement(graph, bad, until).found();
}

}  // namespace cosim::proof
