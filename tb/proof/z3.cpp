#include "tb/proof/z3.h"

#include <sstream>

#include "tb/util/output_file.h"
#include "tb/util/process.h"
#include "tb/util/scratch.h"

namespace cosim::proof {

Solved solve_by_z3(const std::string& script, int limit) {
  constexpr int no_program = 127;
  const Scratch scratch;
  const std::string name = (scratch.path() / "script.smt2").string();
  OutputFile file(name);
  file.text(script);
  file.close();
  const Ended ended = run_program({"z3", "-smt2", name}, limit);
  Solved solved;
  solved.seconds = ended.seconds;
  std::istringstream lines(ended.text);
  for (std::string line; std::getline(lines, line);) {
    if (line == "sat") {
      solved.answers.push_back(Answer::sat);
    } else if (line == "unsat") {
      solved.answers.push_back(Answer::unsat);
    } else if (line == "unknown") {
      solved.answers.push_back(Answer::unknown);
    } else if (solved.said.empty()) {
      solved.said = line;  // anything else spoils the answer
    }
  }
  if (ended.timed_out) {
    solved.answer = Answer::timed_out;
  } else if (ended.status == no_program) {
    solved.answer = Answer::missing;
  } else if (ended.status == 0 && solved.said.empty() && !solved.answers.empty()) {
    solved.answer = solved.answers.front();
  }
  if (solved.answer == Answer::failed) solved.answers.clear();
  return solved;
}

}  // namespace cosim::proof
