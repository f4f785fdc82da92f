// CaDiCaL, a SAT solver, as a library: clauses over gates (Tseitin's transformation).
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <memory>
#include <vector>

#include "tb/nets/graph.h"
#include "tb/proof/questions.h"

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

/// The gates of a graph without latches as clauses, as far as they are asked for. A tree of
/// conjunctions that nothing else reads is one conjunction of many.
class Clauses {
 public:
  /// `roots`: all that will be asked for. Both must outlive it.
  Clauses(const nets::Graph& graph, const nets::Bits& roots, Sat& sat);

  /// The literal of a bit.
  Sat::Literal of(nets::Bit bit);
  /// After sat: what each input of the graph is; 0 where nothing that was asked for reads it.
  std::vector<bool> inputs() const;

 private:
  Sat::Literal literal(nets::Bit bit) const;
  nets::Bits read_by(std::size_t number) const;
  Sat::Literal made(nets::Gate kind, const nets::Bits& read);

  const nets::Graph& graph_;
  Sat& sat_;
  std::vector<unsigned> reads_;         // how many read a gate
  std::vector<Sat::Literal> literals_;  // by gate; 0 where there is none yet
};

struct Satisfied {
  Answer answer = Answer::unsat;  ///< sat, unsat or timed_out
  std::vector<bool> inputs;       ///< of sat
};

/// Whether inputs of `logic`, which has no latches, make all of `all` 1 and one of `any` too. Ends
/// when it is `until`, or the program is interrupted.
Satisfied satisfy(const nets::Graph& logic, const nets::Bits& all, const nets::Bits& any,
                  std::chrono::steady_clock::time_point until);

}  // namespace cosim::proof
