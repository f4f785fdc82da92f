#include "tb/equiv/unknown.h"

#include <algorithm>
#include <map>
#include <utility>

#include "tb/equiv/clocks.h"
#include "tb/support/random.h"

namespace cosim::equiv {
namespace {

using proof::Aig;
using Lit = Aig::Lit;

// Clock after clock of the old RTL as logic alone, on the inputs of a stimulus; free is only what
// it leaves x (bounded model checking).
class Unrolled {
 public:
  Unrolled(const Question& q, const Product& product, const proof::Reached& reached)
      : q_(q), clocks_(reached.inputs.size()) {
    for (const auto& [name, lit] : product.inputs) watch(input_at_, name, lit);
    for (const auto& [name, lit] : product.beginnings) watch(first_at_, name, lit);
    values_ = product.graph.run(reached.inputs, watched_);
    std::vector<Lit> state = at_first();
    const std::size_t last = clocks_ - 1 - static_cast<std::size_t>(q.latency);
    for (clock_ = 0; clock_ <= last; ++clock_) {
      std::vector<Lit> unknown(q.gold.unknowns);
      for (std::size_t i = 0; i < unknown.size(); ++i) unknown[i] = free(i);
      Side::Made made = q.gold.make(
          graph_, [&](const Name& name) { return given(name); }, unknown, state);
      state = std::move(made.next);
      outputs_ = std::move(made.outputs);
    }
  }

  /// Whether an output of the last clock can be other than `value`; then `with` is such an x.
  proof::Ever other(const Name& output, bool value, Filler& with) const {
    const Lit lit = outputs_.at(output);
    const auto reached =
        proof::reach(graph_, value ? Aig::inverted(lit) : lit, q_.budget.ends(), q_.jobs);
    if (reached.ever != proof::Ever::yes) return reached.ever;
    with.assign(clocks_, std::vector<bool>(unknown_bits(q_)));
    for (std::size_t i = 0; i < free_.size(); ++i) {
      with[free_[i].first][free_[i].second] = reached.inputs.front()[i];
    }
    return reached.ever;
  }

 private:
  void watch(std::map<Name, std::size_t>& at, const Name& name, Lit lit) {
    at[name] = watched_.size();
    watched_.push_back(lit);
  }
  Lit free(std::size_t bit) {
    free_.emplace_back(clock_, bit);
    return graph_.input();
  }
  Lit given(const Name& name) const {
    if (const auto at = input_at_.find(name); at != input_at_.end()) {
      return values_[clock_][at->second] ? 1 : 0;
    }
    return tied_bit(q_, name).value_or(false) ? 1 : 0;  // else it is the clock
  }
  std::vector<Lit> at_first() {
    std::vector<Lit> state;
    std::size_t alone = q_.gold.unknowns;
    for (const Register& r : q_.gold.registers) {
      const auto shared = first_at_.find(r.name);
      if (!r.any) {
        state.push_back(r.first ? 1 : 0);
      } else if (shared != first_at_.end()) {
        state.push_back(values_.front()[shared->second] ? 1 : 0);
      } else {
        state.push_back(free(alone++));
      }
    }
    return state;
  }

  const Question& q_;
  std::size_t clocks_, clock_ = 0;
  std::vector<Lit> watched_;
  std::map<Name, std::size_t> input_at_, first_at_;
  std::vector<std::vector<bool>> values_;
  Aig graph_;
  std::vector<std::pair<std::size_t, std::size_t>> free_;  // by input: its clock, its bit of a row
  std::map<Name, Lit> outputs_;
};

}  // namespace

std::vector<Filler> first_fillers(std::size_t bits) {
  constexpr std::uint64_t copies = 6;
  std::vector<Filler> all;
  for (std::uint64_t c = 0; c < copies; ++c) {
    std::vector<bool> row(bits, c == 1);
    for (std::size_t i = 0; c > 1 && i < bits; ++i) {
      row[i] = (Random::for_case(c, i).next() >> 63U) != 0;
    }
    all.push_back({row});
  }
  return all;
}

Certain certain_of(const Question& q, const Product& product, const proof::Reached& reached) {
  std::vector<Name> names;
  std::vector<Lit> watched;
  for (const auto& [name, lit] : product.gold) {
    names.push_back(name);
    for (const Lit one : {lit, product.gate.at(name), product.any.at(name)}) watched.push_back(one);
  }
  const auto last = product.graph.run(reached.inputs, watched).back();
  const Unrolled unrolled(q, product, reached);
  Certain certain;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool gold = last[3 * i], gate = last[3 * i + 1], any = last[3 * i + 2];
    if (any || gold == gate) continue;
    Filler other;
    const proof::Ever ever = unrolled.other(names[i], gold, other);
    if (ever == proof::Ever::never) {
      certain.any = true;
      continue;
    }
    certain.open.insert(names[i]);
    if (ever != proof::Ever::yes) continue;
    // What is right on this clock is often so on all of them.
    for (const std::vector<bool>& row : other) {
      const bool is_set = std::ranges::find(row, true) != row.end();
      if (is_set) certain.others.push_back({row});
    }
    certain.others.push_back(std::move(other));
  }
  return certain;
}

}  // namespace cosim::equiv
