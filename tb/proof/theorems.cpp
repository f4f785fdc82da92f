#include "tb/proof/theorems.h"

#include <fmt/core.h>

#include <iterator>

#include "model/core/input_error.h"
#include "tb/proof/z3.h"

namespace cosim::proof {

std::vector<Theorem> joined(std::vector<std::vector<Theorem>> lists) {
  std::vector<Theorem> all;
  for (auto& list : lists) std::move(list.begin(), list.end(), std::back_inserter(all));
  return all;
}

Judgement judged(const Theorem& theorem, int limit) {
  Judgement all{true, false, "proved", 0};
  const auto ask = [&](const std::vector<ScriptOf>& scripts, Answer wanted, const char* otherwise) {
    for (const ScriptOf& one : scripts) {
      if (!all.proved) return;
      const Solved solved = solve_by_z3(one.script, limit);
      all.seconds += solved.seconds;
      if (solved.answer == wanted) continue;
      if (solved.answer == Answer::missing) throw InputError("needs z3");
      const bool is_opposite = solved.answer == Answer::sat || solved.answer == Answer::unsat;
      all = {false, solved.answer == Answer::timed_out,
             is_opposite ? fmt::format("{} ({})", otherwise, one.what)
                         : fmt::format("UNDECIDED: {} ({}){}", to_text(solved.answer), one.what,
                                       solved.said.empty() ? "" : ": " + solved.said),
             all.seconds};
    }
  };
  ask(theorem.negated, Answer::unsat, "REFUTED");
  ask(theorem.premises, Answer::sat, "its premises cannot be");
  return all;
}

}  // namespace cosim::proof
