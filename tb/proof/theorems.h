// What is claimed of a design beyond its RTL, as theorems on its golden model. A design brings them
// by defining std::vector<Theorem> cosim::DESIGN::theorems() in tb/designs/DESIGN/proof.
#pragma once

#include <string>
#include <vector>

namespace cosim::proof {

/// For z3: a script of one question, and a few words on what it is of.
struct ScriptOf {
  std::string what, script;
};

struct Theorem {
  std::string design;
  std::string sentence;            ///< for a person, whole
  std::vector<ScriptOf> negated;   ///< none can be
  std::vector<ScriptOf> premises;  ///< each can be: the theorem says something
};

/// Those of all designs; made by CMake.
std::vector<Theorem> theorems();

struct Judgement {
  bool proved = false;
  bool timed_out = false;
  std::string verdict;  ///< "proved", "REFUTED (W=8)", "UNDECIDED: timed out (W=32)"
  double seconds = 0;   ///< of processor time
};
/// Asks z3, `limit` seconds of processor time at the most for a question. InputError where there is
/// none.
Judgement judged(const Theorem& theorem, int limit);

/// Several lists as one.
std::vector<Theorem> joined(std::vector<std::vector<Theorem>> lists);

}  // namespace cosim::proof
