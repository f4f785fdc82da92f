#include "tb/proof/decide.h"

#include <fmt/core.h>

#include <array>

#include "tb/support/parallel.h"

namespace cosim::proof {
namespace {

// One solver's answers to one claim.
struct Summary {
  bool as_wanted = true;
  bool opposite = false;
  std::string text;  // of the first answer that is not as wanted
};

Summary summary(const Claim& claim, const std::vector<Solved>& solved) {
  Summary all;
  const Answer other = claim.wanted == Answer::sat ? Answer::unsat : Answer::sat;
  for (std::size_t q = 0; q < solved.size(); ++q) {
    const Query& query = claim.queries[q];
    for (std::size_t i = 0; i < query.asks.size(); ++i) {
      const bool answered = i < solved[q].answers.size();
      const Answer answer = answered ? solved[q].answers[i] : solved[q].answer;
      if (answered && answer == claim.wanted) continue;
      all.as_wanted = false;
      all.opposite = all.opposite || (answered && answer == other);
      if (!all.text.empty() && answer != other) continue;
      all.text = fmt::format("{} ({})", to_text(answer), query.asks[i]);
      if (answer == Answer::failed) all.text += ": " + solved[q].said;
    }
  }
  if (all.text.empty()) all.text = to_text(claim.wanted);
  return all;
}

}  // namespace

Decision judged(const Claim& claim, std::vector<std::vector<Solved>> solved) {
  Decision d;
  std::size_t yes = 0, no = 0;
  std::string answers;
  for (std::size_t v = 0; v < solved.size(); ++v) {
    const Summary s = summary(claim, solved[v]);
    yes += s.as_wanted ? 1 : 0;
    no += s.opposite ? 1 : 0;
    answers += fmt::format("{}{} {}", v == 0 ? "" : ", ", solvers()[v].name, s.text);
    d.seconds.push_back(0);
    for (const Solved& one : solved[v]) d.seconds.back() += one.seconds;
  }
  d.proved = !solved.empty() && yes == solved.size();
  d.refuted = no > 0 && yes == 0;
  if (d.proved) {
    d.verdict = "proved";
  } else if (d.refuted) {
    d.verdict = "REFUTED: " + answers;
  } else {
    d.verdict = (yes > 0 && no > 0 ? "THE SOLVERS DISAGREE: " : "UNDECIDED: ") + answers;
  }
  d.solved = std::move(solved);
  return d;
}

std::vector<Decision> decide(const std::vector<const Claim*>& claims, int limit, unsigned jobs) {
  std::vector<std::array<std::size_t, 3>> work;  // claim, query, solver
  std::vector<std::vector<std::vector<Solved>>> solved(claims.size());
  for (std::size_t c = 0; c < claims.size(); ++c) {
    const std::size_t queries = claims[c]->queries.size();
    solved[c].assign(solvers().size(), std::vector<Solved>(queries));
    for (std::size_t q = 0; q < queries; ++q) {
      for (std::size_t v = 0; v < solvers().size(); ++v) work.push_back({c, q, v});
    }
  }
  in_parallel(work.size(), jobs, [&](std::uint64_t i) {
    const auto [c, q, v] = work[i];
    const Query& query = claims[c]->queries[q];
    solved[c][v][q] = solve(solvers()[v], query.script, limit, query.eager);
    return true;
  });
  std::vector<Decision> all;
  for (std::size_t c = 0; c < claims.size(); ++c) {
    all.push_back(judged(*claims[c], std::move(solved[c])));
  }
  return all;
}

bool timed_out(const std::vector<Decision>& decisions) {
  for (const Decision& d : decisions) {
    for (const auto& by_solver : d.solved) {
      for (const Solved& s : by_solver) {
        if (s.answer == Answer::timed_out) return true;
      }
    }
  }
  return false;
}

}  // namespace cosim::proof
