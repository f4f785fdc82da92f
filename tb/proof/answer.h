// What an engine says of a question.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/core/value.h"

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

}  // namespace cosim::proof
