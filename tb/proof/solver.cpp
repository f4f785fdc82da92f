#include "tb/proof/solver.h"

#include <sstream>
#include <vector>

#include "tb/support/output_file.h"
#include "tb/support/pattern.h"
#include "tb/support/process.h"

namespace cosim::proof {
namespace {

constexpr int kMissing = 127;

std::map<std::string, std::string> values_in(const std::string& text) {
  static const Pattern pair(
      R"(\((\|[^|]*\||[^\s()]+)\s+(#[bx][0-9a-f]+|true|false|\d+|\(- \d+\))\))");
  std::map<std::string, std::string> values;
  for (const Pattern::Parts& part : pair.all(text)) values[part[1]] = part[2];
  return values;
}

// Runs a solver on a script, and adds up the processor time it took.
Ended run(const Solver& solver, const std::string& script, int limit, const std::string& options,
          double& seconds, const std::atomic<bool>* no_more = nullptr) {
  const Scratch scratch;
  const std::string name = (scratch.path() / "script.smt2").string();
  OutputFile file(name);
  file.text(script);
  file.close();

  std::vector<std::string> words;
  std::istringstream command(solver.command + ' ' + options);
  for (std::string word; command >> word;) words.push_back(word);
  if (solver.name == "cvc5" && script.find("(push") != std::string::npos) {
    words.emplace_back("--incremental");
  }
  words.push_back(name);

  Ended ended = run_program(words, limit, no_more);
  seconds += ended.seconds;
  return ended;
}

}  // namespace

std::string to_text(Answer answer) {
  switch (answer) {
    case Answer::sat:
      return "sat";
    case Answer::unsat:
      return "unsat";
    case Answer::unknown:
      return "unknown";
    case Answer::timed_out:
      return "timed out";
    case Answer::missing:
      return "missing";
    case Answer::stopped:
      return "stopped";
    case Answer::failed:
      return "failed";
  }
  return "failed";
}

const std::vector<Solver>& solvers() {
  // Conditions as words of one bit take cvc5 a third of the time where long sums are compared, and
  // several times as long for what is easy.
  static const std::vector<Solver> list = {
      {"cvc5", "cvc5 --lang=smt2", "--bitblast=eager", "--bool-to-bv=all"}, {"z3", "z3 -smt2"}};
  return list;
}

Solved solve(const Solver& solver, const std::string& script, int limit, bool eager,
             const std::atomic<bool>* no_more) {
  Solved solved;
  const bool twice = eager && !solver.harder.empty() && limit > kSoon;
  const auto is_stopped = [&] { return no_more != nullptr && *no_more; };
  Ended ended = run(solver, script, twice ? kSoon : limit, eager ? solver.eager : "",
                    solved.seconds, no_more);
  if (twice && ended.timed_out && !is_stopped()) {
    ended = run(solver, script, limit - kSoon, solver.eager + ' ' + solver.harder, solved.seconds,
                no_more);
  }
  std::istringstream lines(ended.text);
  for (std::string line; std::getline(lines, line);) {
    if (line == "sat") {
      solved.answers.push_back(Answer::sat);
    } else if (line == "unsat") {
      solved.answers.push_back(Answer::unsat);
    } else if (line == "unknown") {
      solved.answers.push_back(Answer::unknown);
    } else if (solved.said.empty()) {
      solved.said = line;  // anything else spoils the answers
    }
  }
  if (ended.timed_out) {
    solved.answer = is_stopped() ? Answer::stopped : Answer::timed_out;
  } else if (ended.status == kMissing) {
    solved.answer = Answer::missing;
  } else if (ended.status == 0 && solved.said.empty() && !solved.answers.empty()) {
    solved.answer = solved.answers.front();
  }
  if (solved.answer == Answer::failed) solved.answers.clear();
  return solved;
}

std::map<std::string, std::string> values(const Solver& solver, const std::string& script,
                                          const std::vector<std::string>& terms, int limit) {
  std::string asking = script + "(get-value (";
  for (const std::string& term : terms) asking += ' ' + term;
  double seconds = 0;
  return values_in(run(solver, asking + "))\n", limit, "", seconds).text);
}

}  // namespace cosim::proof
