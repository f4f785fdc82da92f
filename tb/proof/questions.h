// Questions about gates: can a bit of a graph be 1?
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "model/core/value.h"
#include "tb/nets/graph.h"

namespace cosim::proof {

enum class Answer {
  sat,      ///< it can be so
  unsat,    ///< it cannot
  unknown,  ///< the engine gave up
  timed_out,
  missing,  ///< there is no such engine
  stopped,  ///< another had answered before
  failed,   ///< the engine did not understand, or died
};

/// "unsat", "timed out", ...
std::string to_text(Answer answer);

struct Solved {
  Answer answer = Answer::failed;  ///< of the first question, or why there is none
  std::vector<Answer> answers;     ///< of all that were answered
  double seconds = 0;              ///< of processor time
  std::string said;                ///< the engine's words where it failed
  /// What the terms are of the first question that was answered with "sat".
  std::map<std::string, Word> values;
};

struct Questions {
  nets::Graph graph;
  std::vector<nets::Port> inputs;  ///< its free bits
  std::vector<nets::Port> asked;   ///< each bit with a few words
  /// The codes of what a counterexample shows, lowest bit first, by its terms (term_of).
  std::map<std::string, std::vector<nets::Bit>> terms;
};

/// Each bit that is asked as binary AIGER, in the order of questions.asked, with the names of its
/// inputs.
std::vector<std::string> as_aiger(const Questions& questions);

}  // namespace cosim::proof
