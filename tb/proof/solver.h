// Solvers of SMT-LIB 2 scripts.
#pragma once

#include <atomic>
#include <map>
#include <string>
#include <vector>

namespace cosim::proof {

enum class Answer {
  sat,      ///< it can be so
  unsat,    ///< it cannot
  unknown,  ///< the solver gave up
  timed_out,
  missing,  ///< there is no such solver
  stopped,  ///< others had answered before
  failed,   ///< the solver did not understand, or died
};

/// "unsat", "timed out", ...
std::string to_text(Answer answer);

struct Solver {
  std::string name;  ///< for a person
  /// The program and its options; the script's file is put behind them.
  std::string command;
  /// Further options, for scripts of nothing but bit vectors; may be empty.
  std::string on_bit_vectors = "";
  /// Whether it takes several scripts at a time: to start it takes longer than an easy script.
  bool takes_many = false;
  /// Whether it reads thousands of `let`, one in the other.
  bool takes_lets = false;
};

/// cvc5 and z3.
const std::vector<Solver>& solvers();

struct Solved {
  Answer answer = Answer::failed;  ///< of the first question, or why there is none
  std::vector<Answer> answers;     ///< of all that were answered
  double seconds = 0;              ///< of processor time
  std::string said;                ///< the solver's words where it failed
  /// What the terms are of the first question that was answered with "sat", where the answer came
  /// with them.
  std::map<std::string, std::string> values;
};

/// Has a solver answer the questions of a script, in `limit` seconds of processor time at the most.
/// It is stopped when `no_more` becomes true.
Solved solve(const Solver& solver, const std::string& script, int limit,
             const std::atomic<bool>* no_more = nullptr);

/// The same of several scripts, which a solver that takes many is given at a time. The seconds are
/// those of the first.
std::vector<Solved> solve_all(const Solver& solver, const std::vector<std::string>& scripts,
                              int limit, const std::atomic<bool>* no_more = nullptr);

/// What the terms are where the one question of a script is answered with "sat"; empty where not.
std::map<std::string, std::string> values(const Solver& solver, const std::string& script,
                                          const std::vector<std::string>& terms, int limit);

}  // namespace cosim::proof
