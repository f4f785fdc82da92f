#include "tb/equiv/product.h"

#include <algorithm>
#include <map>
#include <utility>

#include "tb/equiv/clocks.h"
#include "tb/nets/runs.h"
#include "tb/util/random.h"

namespace cosim::equiv {
namespace {

// Clock after clock of the old RTL as logic alone, on the inputs of a stimulus; free is only what
// it leaves x (bounded model checking).
class Unrolled {
 public:
  Unrolled(const Question& q, const Product& product, const proof::Reached& reached)
      : q_(q), clocks_(reached.inputs.size()) {
    for (const auto& [name, lit] : product.inputs) watch(input_at_, name, lit);
    for (const auto& [name, lit] : product.beginnings) watch(first_at_, name, lit);
    values_ = nets::traced(product.graph, reached.inputs, watched_);
    Bits state = at_first();
    const std::size_t last = clocks_ - 1 - static_cast<std::size_t>(q.latency);
    for (clock_ = 0; clock_ <= last; ++clock_) {
      Bits unknown(q.gold.unknowns);
      for (std::size_t i = 0; i < unknown.size(); ++i) unknown[i] = free(i);
      Side::Made made = q.gold.make(
          graph_, [&](const Name& name) { return given(name); }, unknown, state);
      state = std::move(made.next);
      outputs_ = std::move(made.outputs);
    }
  }

  /// Whether an output of the last clock can be other than `value`; then `with` is such an x.
  proof::Ever other(const Name& output, bool value, Filler& with) const {
    const Bit lit = outputs_.at(output);
    const auto reached = proof::reach(graph_, value ? !lit : lit, q_.budget.ends(), q_.jobs);
    if (reached.ever != proof::Ever::yes) return reached.ever;
    with.assign(clocks_, std::vector<bool>(unknown_bits(q_)));
    for (std::size_t i = 0; i < free_.size(); ++i) {
      with[free_[i].first][free_[i].second] = reached.inputs.front()[i];
    }
    return reached.ever;
  }

 private:
  void watch(std::map<Name, std::size_t>& at, const Name& name, Bit lit) {
    at[name] = watched_.size();
    watched_.push_back(lit);
  }
  Bit free(std::size_t bit) {
    free_.emplace_back(clock_, bit);
    return graph_.input();
  }
  Bit given(const Name& name) const {
    if (const auto at = input_at_.find(name); at != input_at_.end()) {
      return values_[clock_][at->second] ? yes : no;
    }
    return tied_bit(q_, name).value_or(false) ? yes : no;  // else it is the clock
  }
  Bits at_first() {
    Bits state;
    std::size_t alone = q_.gold.unknowns;
    for (const Register& r : q_.gold.registers) {
      const auto shared = first_at_.find(r.name);
      if (!r.any) {
        state.push_back(r.first ? yes : no);
      } else if (shared != first_at_.end()) {
        state.push_back(values_.front()[shared->second] ? yes : no);
      } else {
        state.push_back(free(alone++));
      }
    }
    return state;
  }

  const Question& q_;
  std::size_t clocks_, clock_ = 0;
  Bits watched_;
  std::map<Name, std::size_t> input_at_, first_at_;
  std::vector<std::vector<bool>> values_;
  Graph graph_;
  std::vector<std::pair<std::size_t, std::size_t>> free_;  // by input: its clock, its bit of a row
  std::map<Name, Bit> outputs_;
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
  Bits watched;
  for (const auto& [name, lit] : product.gold) {
    names.push_back(name);
    for (const Bit one : {lit, product.gate.at(name), product.any.at(name)}) watched.push_back(one);
  }
  const auto last = nets::traced(product.graph, reached.inputs, watched).back();
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
