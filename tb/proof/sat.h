// CaDiCaL, a SAT solver, as a library: clauses over gates (Tseitin's transformation).
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <vector>

#include "tb/proof/answer.h"

namespace cosim::proof {

class Sat {
 public:
  /// A variable, from 1 on, or its negation.
  using Literal = int;

  /// `is_over` is asked now and then while it solves, and ends that.
  explicit Sat(std::function<bool()> is_over);
  ~Sat();
  Sat(const Sat&) = delete;
  Sat& operator=(const Sat&) = delete;

  /// A new variable.
  Literal variable() { return ++variables_; }
  void clause(std::initializer_list<Literal> literals);
  void clause(const std::vector<Literal>& literals);
  /// New variables that are all of them, one of a and b, and `then` where `condition` is, else
  /// `otherwise`.
  Literal and_of(const std::vector<Literal>& all);
  Literal xor_of(Literal a, Literal b);
  Literal choose(Literal condition, Literal then, Literal otherwise);

  /// Whether all clauses can hold where these literals do: sat, unsat, or timed_out where it was
  /// over before that was known. More clauses and questions may follow.
  Answer solve(const std::vector<Literal>& assumed = {});
  /// After sat: whether it holds there.
  bool holds(Literal literal) const;

 private:
  class Solver;
  std::unique_ptr<Solver> solver_;
  Literal variables_ = 0;
};

}  // namespace cosim::proof
