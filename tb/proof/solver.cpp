#include "tb/proof/solver.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "model/core/input_error.h"
#include "tb/proof/expression.h"
#include "tb/support/output_file.h"
#include "tb/support/pattern.h"
#include "tb/support/process.h"
#include "tb/support/scratch.h"

namespace cosim::proof {
namespace {

constexpr int kMissing = 127;
constexpr const char* kNext = "next-script";

std::map<std::string, std::string> values_in(const std::string& text) {
  static const Pattern pair(
      R"(\((\|[^|]*\||[^\s()]+)\s+(#[bx][0-9a-f]+|true|false|\d+|\(- \d+\))\))");
  std::map<std::string, std::string> values;
  for (const Pattern::Parts& part : pair.all(text)) values[part[1]] = part[2];
  return values;
}

// Runs a solver on a script, and adds up the processor time it took.
Ended run(const Solver& solver, const std::string& script, int limit, double& seconds,
          const std::atomic<bool>* no_more = nullptr) {
  const Scratch scratch;
  const std::string name = (scratch.path() / "script.smt2").string();
  OutputFile file(name);
  try {
    file.text(script);
    file.close();
  } catch (const InputError&) {
    require_room(scratch.path());  // what was written of it is still there
    throw;
  }

  std::vector<std::string> words;
  const bool is_bit_vectors = script.find("(set-logic QF_BV)") != std::string::npos;
  std::istringstream command(solver.command + (is_bit_vectors ? ' ' + solver.on_bit_vectors : ""));
  for (std::string word; command >> word;) words.push_back(word);
  if (solver.name == "cvc5" && script.find("(push") != std::string::npos) {
    words.emplace_back("--incremental");
  }
  words.push_back(name);

  Ended ended = run_program(words, limit, no_more);
  seconds += ended.seconds;
  return ended;
}

std::string given(const Solver& solver, const std::string& script) {
  return solver.takes_lets && script.find("(push") == std::string::npos ? with_lets(script)
                                                                        : script;
}

bool is_set(const std::atomic<bool>* flag) { return flag != nullptr && *flag; }

// What a solver said of a script. Where that `is_all` it said, how it ended counts as well.
Solved said(const Ended& ended, const std::string& text, bool is_all,
            const std::atomic<bool>* no_more) {
  Solved solved;
  std::istringstream lines(text);
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
  if (is_all && ended.timed_out) {
    solved.answer = is_set(no_more) ? Answer::stopped : Answer::timed_out;
  } else if (is_all && ended.status == kMissing) {
    solved.answer = Answer::missing;
  } else if ((!is_all || ended.status == 0) && solved.said.empty() && !solved.answers.empty()) {
    solved.answer = solved.answers.front();
  }
  if (solved.answer == Answer::failed) solved.answers.clear();
  return solved;
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
  // Conditions as words of one bit take cvc5 a third of the time where long sums are compared. For
  // z3 sums and conjunctions stay as they are written: where it makes one of many terms of them,
  // the two sides share less, and the 51 claims take it half as long again.
  static const std::vector<Solver> list = {
      {"cvc5", "cvc5 --lang=smt2", "--bitblast=eager --bool-to-bv=all"},
      {"z3", "z3 -smt2 rewriter.flat=false", "", true, true}};
  return list;
}

Solved solve(const Solver& solver, const std::string& script, int limit,
             const std::atomic<bool>* no_more) {
  double seconds = 0;
  const Ended ended = run(solver, given(solver, script), limit, seconds, no_more);
  Solved solved = said(ended, ended.text, true, no_more);
  solved.seconds = seconds;
  return solved;
}

std::vector<Solved> solve_all(const Solver& solver, const std::vector<std::string>& scripts,
                              int limit, const std::atomic<bool>* no_more) {
  std::string all;
  for (const std::string& script : scripts) {
    all += given(solver, script) + fmt::format("(echo \"{}\")\n(reset)\n", kNext);
  }
  double seconds = 0;
  const Ended ended = run(solver, all, limit, seconds, no_more);
  std::vector<Solved> solved;
  for (std::size_t begin = 0; solved.size() < scripts.size();) {
    const std::size_t end = std::min(ended.text.find(kNext, begin), ended.text.size());
    const bool is_last = end == ended.text.size();
    solved.push_back(said(ended, ended.text.substr(begin, end - begin), is_last, no_more));
    begin = is_last ? end : ended.text.find('\n', end) + 1;
  }
  solved.front().seconds = seconds;
  return solved;
}

std::map<std::string, std::string> values(const Solver& solver, const std::string& script,
                                          const std::vector<std::string>& terms, int limit) {
  std::string asking = script + "(get-value (";
  for (const std::string& term : terms) asking += ' ' + term;
  double seconds = 0;
  return values_in(run(solver, asking + "))\n", limit, seconds).text);
}

}  // namespace cosim::proof
