// The ways through a function that is run on symbols: once for each, a condition that forks being
// true first and false then, and what comes of them joined. Exporter alone.
#pragma once

#include <algorithm>
#include <compare>
#include <ctime>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/clocked/graph.h"
#include "model/clocked/source_line.h"
#include "model/core/input_error.h"

namespace cosim::clocked {

/// What a condition is on a way.
struct Decision {
  const void* from;  ///< the address that asks it
  bool yes;
  auto operator<=>(const Decision&) const = default;
};
struct Way {
  std::vector<Decision> decisions;  ///< its forks, the first one first
  Id holds;                         ///< whether all are so: a node of one bit
};
struct Branch {
  Decision decision;
  bool is_in_block;  ///< of merge()
  Id holds;          ///< whether the condition is asked there and so
};

class Ways {
 public:
  static constexpr std::size_t most_listed = 256;
  std::uint64_t most_ways = 1'000'000;
  double most_seconds = 10;  ///< of a processor: other work does not count

  /// Ways run so far, those through blocks of merge() too.
  std::uint64_t count() const { return count_; }

  /// Begins with a model; `name` is for errors.
  void begin(std::string name) {
    script_ = {};
    asked_.clear();
    count_ = 0;
    depth_ = 0;
    keeps_ = false;
    name_ = std::move(name);
    begun_ = std::clock();
    graph.watch = nullptr;
  }

  /// The next join() keeps its ways and branches.
  void keep() {
    keeps_ = true;
    listed_.clear();
    branches_.clear();
  }
  /// Its ways, but for those through blocks of merge(); none where they are more than most_listed.
  std::vector<Way> listed() const {
    return listed_.size() > most_listed ? std::vector<Way>() : listed_;
  }
  /// Every condition, with each value that it has on some way.
  std::vector<Branch> branches() const {
    std::vector<Branch> all;
    for (const auto& [branch, i] : branches_) {
      all.push_back({branch.first, branch.second, script_.taken[i]});
    }
    return all;
  }

  /// Whether the condition holds on this way. It is asked at the address `from`.
  bool ask(Id condition, const void* from) {
    const bool is_not = graph[condition].op == Op::bnot;
    if (is_not) condition = graph[condition].a;
    if (const Wide* value = graph.known(condition)) return (*value != Wide(0)) != is_not;
    if (const int fact = known(condition)) return taken({from, (fact > 0) != is_not});
    auto& forks = script_.forks;
    auto& at = script_.at;
    if (at == forks.size()) {
      ++asked_[from];
      forks.push_back({condition, true, is_not, from, {}, {}});
      if (forks.size() % 1024 == 0) check(forks.size() > most_forks);
    } else if (forks[at].condition != condition) {
      unlike();
    }
    const bool yes = forks[at++].yes;
    learn(condition, yes);
    return taken({from, yes != is_not});
  }

  /// Calls run() once for each way through it, always from the same values; it gives the nodes that
  /// it came to, which are joined.
  template <class Run>
  std::vector<Id> join(Run run) {
    Script outer = script_;
    ++depth_;
    graph.watch = watch;
    std::vector<Fork>& forks = script_.forks;
    forks.clear();
    std::vector<Id> nodes;
    for (;;) {
      script_.at = 0;
      script_.facts = outer.facts;
      script_.values = outer.values;
      script_.taken.clear();
      nodes = run();
      check(++count_ > most_ways);
      if (script_.at != forks.size()) unlike();
      if (keeps_ && depth_ == 1) list_way();
      while (!forks.empty() && !forks.back().yes) {
        const Fork& fork = forks.back();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          nodes[i] = graph.ite(fork.condition, fork.nodes[i], nodes[i]);
        }
        script_.taken = either(fork.condition, fork.taken, script_.taken);
        forks.pop_back();
      }
      if (forks.empty()) break;
      forks.back().yes = false;
      forks.back().nodes = std::move(nodes);
      forks.back().taken = std::move(script_.taken);
    }
    outer.taken.resize(std::max(outer.taken.size(), script_.taken.size()));
    for (std::size_t i = 0; i < script_.taken.size(); ++i) {
      Id& all = outer.taken[i];
      const Id here = script_.taken[i];
      if (here != 0) all = all == 0 ? here : graph.make(Op::bor, 1, all, here);
    }
    script_ = std::move(outer);
    if (--depth_ == 0) {
      keeps_ = false;
      graph.watch = nullptr;
    }
    return nodes;
  }
  /// As join(). InputError where a second time gives other nodes.
  template <class Run>
  std::vector<Id> join_twice(Run run) {
    std::vector<Id> nodes = join(run);
    const std::uint64_t once = count_;
    if (join(run) != nodes) unlike();
    count_ = once;
    return nodes;
  }

 private:
  static constexpr std::size_t most_forks = 100'000;
  struct Fork {
    Id condition;
    bool yes;     // the way that is run
    bool is_not;  // the inverse of the condition is asked
    const void* from;
    std::vector<Id> nodes, taken;  // where yes is false, what came of the other way
  };

  struct Script {
    std::vector<Fork> forks;
    std::size_t at = 0;                  // of the next fork on this way
    std::unordered_map<Id, bool> facts;  // conditions known on this way
    std::unordered_map<Id, Id> values;   // nodes known to be a constant
    std::vector<Id> taken;               // the branches, by their numbers: whether taken; 0: no
  };

  bool taken(const Decision& decision) {
    if (!keeps_) return decision.yes;
    const std::pair branch(decision, depth_ > 1);
    const std::size_t i = branches_.try_emplace(branch, branches_.size()).first->second;
    if (script_.taken.size() <= i) script_.taken.resize(i + 1);
    script_.taken[i] = graph.constant(1, 1);
    return decision.yes;
  }
  static std::vector<Id> either(Id condition, std::vector<Id> yes, std::vector<Id> no) {
    const std::size_t n = std::max(yes.size(), no.size());
    yes.resize(n);
    no.resize(n);
    const auto bit = [](Id id) { return id != 0 ? id : graph.constant(1, 0); };
    for (std::size_t i = 0; i < n; ++i) {
      if (yes[i] != no[i]) no[i] = graph.ite(condition, bit(yes[i]), bit(no[i]));
    }
    return no;
  }
  void list_way() {
    if (listed_.size() > most_listed) return;
    Way way{{}, graph.constant(1, 1)};
    for (const Fork& f : script_.forks) {
      way.decisions.push_back({f.from, f.yes != f.is_not});
      way.holds = graph.make(Op::band, 1, way.holds, f.yes ? f.condition : graph.bnot(f.condition));
    }
    listed_.push_back(std::move(way));
  }

  /// 1 or -1 where the condition is known to be true or false, else 0.
  int known(Id condition, int depth = 8) const {
    if (const auto fact = script_.facts.find(condition); fact != script_.facts.end())
      return fact->second ? 1 : -1;
    const Node& n = graph[condition];
    if (n.op == Op::bnot) return depth > 0 ? -known(n.a, depth - 1) : 0;
    if (n.op == Op::band || n.op == Op::bor) {
      const int enough = n.op == Op::band ? -1 : 1;  // of one of both
      if (depth == 0) return 0;
      const int a = known(n.a, depth - 1), b = known(n.b, depth - 1);
      return a == enough || b == enough ? enough : a == b ? a : 0;
    }
    if (n.op != Op::eq || graph.known(n.b) == nullptr) return 0;
    const auto value = script_.values.find(n.a);
    return value == script_.values.end() ? 0 : value->second == n.b ? 1 : -1;
  }
  void learn(Id condition, bool yes) {
    const Node& n = graph[condition];
    script_.facts[condition] = yes;
    if (n.op == Op::bnot) learn(n.a, !yes);
    if (n.op == (yes ? Op::band : Op::bor)) {
      learn(n.a, yes);
      learn(n.b, yes);
    }
    if (n.op == Op::eq && yes && graph.known(n.b) != nullptr) script_.values[n.a] = n.b;
  }
  static void watch();  // a loop may ask no symbol
  void check(bool is_too_many) const {
    if (!is_too_many && double(std::clock() - begun_) < most_seconds * CLOCKS_PER_SEC) return;
    auto most = asked_.begin();
    for (auto i = asked_.begin(); i != asked_.end(); ++i) {
      if (i->second > most->second) most = i;
    }
    std::string line = name_ + ": " + std::to_string(count_) + " ways through clock() and more";
    if (most != asked_.end()) {
      line +=
          "; the condition at " + source_line(most->first) + " forks most, " +
          std::to_string(most->second) +
          (script_.forks.size() > most->second / 2
               ? " times, one after the other: the loop or recursion that it ends may not end"
               : " times: take mux(), or join the ways of its block by merge(*this, [&] { ... })");
    } else {
      line += ": a loop may not end";
    }
    throw InputError(line);
  }
  [[noreturn]] void unlike() const {
    throw InputError(name_ +
                     ": clock() is not the same when it is run again: it may depend on its "
                     "members and on In alone, on no static or global variable and not on time");
  }

  std::string name_;
  std::clock_t begun_ = 0;
  std::uint64_t count_ = 0;
  int depth_ = 0;       // of join()
  bool keeps_ = false;  // ways and branches
  Script script_;
  std::vector<Way> listed_;
  std::map<std::pair<Decision, bool>, std::size_t> branches_;
  std::unordered_map<const void*, std::uint64_t> asked_;
};

inline Ways ways;
inline void Ways::watch() { ways.check(false); }

}  // namespace cosim::clocked
