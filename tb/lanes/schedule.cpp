// An order: from each end (a comparison, a store) depth first to all that it needs, of several
// values first the one that needs the most registers (Sethi-Ullman numbers, of a graph in place of
// a tree); an end runs as soon as all that it reads is there. Registers in that order: the value
// that is used again last leaves (Belady's rule). A local search for a better order of the ends
// would make the clocks of circular and DDA 2 to 19 % faster.
#include "tb/lanes/schedule.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace cosim::lanes {
namespace {

constexpr std::size_t none = Statement::none;

/// The order of the statements from their ends: what an end needs is run close together, and an end
/// as soon as it can be.
class Order {
 public:
  Order(const std::vector<Statement>& statements, std::size_t values)
      : statements_(statements), giver_(values, none), then_(statements.size()) {
    for (std::size_t i = 0; i < statements.size(); ++i) {
      if (statements[i].gives != none) giver_[statements[i].gives] = i;
    }
    for (std::size_t i = 0; i < statements.size(); ++i) {
      if (!is_end(i)) continue;
      ends_.push_back(i);
      for (const std::size_t v : statements[i].reads) {
        if (giver_[v] != none) then_[giver_[v]].push_back(i);
      }
      for (const std::size_t before : statements[i].after) then_[before].push_back(i);
    }
    waits_.resize(statements.size());
    for (const auto& all : then_) {
      for (const std::size_t end : all) ++waits_[end];
    }
    count_needs();
  }

  std::vector<std::size_t> order() {
    done_.assign(statements_.size(), false);
    for (const std::size_t end : ends_) {
      if (waits_[end] == 0 && !done_[end]) run(end);
      for (const std::size_t v : statements_[end].reads) visit(giver_[v]);
    }
    if (order_.size() != statements_.size())
      throw std::logic_error("lanes: a circle of statements");
    return order_;
  }

 private:
  bool is_end(std::size_t i) const { return statements_[i].gives == none; }
  // How many values are alive at most while one is made, the one that needs most made first.
  void count_needs() {
    need_.assign(giver_.size(), 1);
    std::vector<std::size_t> of;
    for (const Statement& s : statements_) {
      if (s.gives == none) continue;
      of.clear();
      for (const std::size_t v : s.reads) of.push_back(need_[v]);
      std::sort(of.rbegin(), of.rend());
      for (std::size_t i = 0; i < of.size(); ++i) {
        need_[s.gives] = std::max(need_[s.gives], of[i] + i);
      }
    }
  }

  void run(std::size_t i) {
    done_[i] = true;
    order_.push_back(i);
    for (const std::size_t end : then_[i]) {
      if (--waits_[end] == 0) run(end);
    }
  }
  void visit(std::size_t root) {
    if (root == none) return;
    stack_.assign(1, root);
    while (!stack_.empty()) {
      const std::size_t i = stack_.back();
      std::size_t next = none;
      if (!done_[i]) {
        for (const std::size_t v : statements_[i].reads) {
          if (giver_[v] == none || done_[giver_[v]]) continue;
          if (next == none || need_[v] > need_[statements_[next].gives]) next = giver_[v];
        }
        if (next == none) run(i);
      }
      if (next == none) {
        stack_.pop_back();
      } else {
        stack_.push_back(next);
      }
    }
  }

  const std::vector<Statement>& statements_;
  std::vector<std::size_t> giver_, need_;       // by value
  std::vector<std::vector<std::size_t>> then_;  // ends that wait for a statement
  std::vector<std::size_t> ends_, waits_;
  std::vector<std::size_t> order_, stack_;
  std::vector<bool> done_;
};

/// Runs them in an order, with so many registers: the value that is needed last leaves first.
class Registers {
 public:
  Registers(const std::vector<Statement>& statements, std::size_t values, std::size_t registers)
      : statements_(statements), registers_(registers), uses_(values) {}

  Schedule run(const std::vector<std::size_t>& order) {
    begin(order);
    for (const std::size_t i : order) {
      const Statement& s = statements_[i];
      for (const std::size_t v : s.reads) {
        if (is_held(v)) continue;
        make_room(s.reads);
        made_.moves.push_back({Move::What::load, v, uses_[v].place});
        hold(v);
      }
      for (const std::size_t v : s.reads) used(v);
      if (s.gives != none && uses_[s.gives].at < uses_[s.gives].end) {
        make_room({});
        hold(s.gives);
      }
      made_.moves.push_back({Move::What::run, i});
    }
    made_.places = places_;
    return std::move(made_);
  }

 private:
  struct Uses {
    std::size_t at = 0, end = 0;  // those to come, in all_
    std::size_t place = none;
    bool in_register = false;
  };

  void begin(const std::vector<std::size_t>& order) {
    for (const Statement& s : statements_) {
      for (const std::size_t v : s.reads) ++uses_[v].end;
    }
    std::size_t sum = 0;
    for (Uses& u : uses_) {
      sum += std::exchange(u.end, sum);
      u.at = u.end;
    }
    all_.resize(sum);
    for (std::size_t t = 0; t < order.size(); ++t) {
      for (const std::size_t v : statements_[order[t]].reads) all_[uses_[v].end++] = t;
    }
    is_given_.assign(uses_.size(), false);
    for (const Statement& s : statements_) {
      if (s.gives != none) is_given_[s.gives] = true;
    }
  }

  bool is_held(std::size_t v) const { return uses_[v].in_register; }
  void hold(std::size_t v) {
    uses_[v].in_register = true;
    held_.push_back(v);
  }
  void leave(std::size_t v) {
    uses_[v].in_register = false;
    held_.erase(std::ranges::find(held_, v));
  }
  void used(std::size_t v) {
    Uses& u = uses_[v];
    if (++u.at < u.end) return;
    leave(v);
    if (u.place != none) free_.push_back(u.place);
  }
  // For one value more, beside these.
  void make_room(const std::vector<std::size_t>& beside) {
    if (held_.size() < registers_) return;
    std::size_t last = none;
    for (const std::size_t v : held_) {
      if (std::ranges::find(beside, v) != beside.end()) continue;
      if (last == none || all_[uses_[v].at] > all_[uses_[last].at]) last = v;
    }
    leave(last);
    Uses& u = uses_[last];
    const bool is_in_memory = u.place != none || !is_given_[last];
    if (!is_in_memory) {
      if (free_.empty()) free_.push_back(places_++);
      u.place = free_.back();
      free_.pop_back();
    }
    made_.moves.push_back({Move::What::leave, last, is_in_memory ? none : u.place});
  }

  const std::vector<Statement>& statements_;
  const std::size_t registers_;
  std::vector<Uses> uses_;        // by value
  std::vector<std::size_t> all_;  // when each value is used, one value behind the other
  std::vector<bool> is_given_;
  std::vector<std::size_t> held_, free_;
  std::size_t places_ = 0;
  Schedule made_;
};

}  // namespace

Schedule scheduled(const std::vector<Statement>& statements, std::size_t values,
                   std::size_t registers) {
  return Registers(statements, values, registers).run(Order(statements, values).order());
}

}  // namespace cosim::lanes
