#include "tb/proof/engines.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/nets/runs.h"
#include "tb/proof/engines_detail.h"
#include "tb/support/words.h"

namespace cosim::proof {

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

std::string to_text(Engine engine) { return engine == Engine::cec ? "cec" : "cadical"; }

std::vector<Engine> all_engines() { return {Engine::cec, Engine::cadical}; }

std::string listed(const std::vector<Engine>& engines) {
  std::string text;
  for (std::size_t i = 0; i < engines.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == engines.size() ? " and " : ", ") + to_text(engines[i]);
  }
  return text;
}

std::vector<Engine> engines_of(const std::string& list) {
  const std::vector<Engine> all = all_engines();
  std::vector<Engine> chosen;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](Engine e) { return to_text(e) == word; });
    if (found == all.end() || std::count(chosen.begin(), chosen.end(), *found) != 0) {
      throw InputError(
          fmt::format("--engines {}: takes {}, each once", in_quotes(list), listed(all)));
    }
    chosen.push_back(*found);
  }
  if (chosen.empty()) throw InputError("--engines: needs one");
  return chosen;
}

Solved solve(Engine engine, const Questions& questions, int limit,
             const std::atomic<bool>* no_more) {
  return engine == Engine::cec ? solve_by_abc(questions, limit, no_more)
                               : solve_by_cadical(questions, limit, no_more);
}

bool take(const Questions& questions, nets::Bit asked, const std::vector<std::uint64_t>& inputs,
          Solved& solved) {
  const auto gates = nets::run(questions.graph, inputs);
  if ((nets::in_runs(gates, asked) & 1) == 0) {
    solved.answer = Answer::failed;
    solved.answers.clear();
    solved.said = "what it found is no answer";
    return false;
  }
  if (solved.values.empty()) solved.values = values_in(questions, gates);
  return true;
}

}  // namespace cosim::proof
