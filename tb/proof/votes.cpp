// A claim that is cut into questions is proved where each of them has as many votes as are needed,
// and refuted where one has. Two engines that contradict each other decide nothing: a conflict,
// which is told.
#include "tb/proof/votes.h"

#include <fmt/core.h>

#include <algorithm>

namespace cosim::proof {
namespace {

// What is asked in one query: of nets in all.
std::vector<std::string> asks_of(Engine engine, const Claim& claim, std::size_t query) {
  if (engine != Engine::cec) return claim.queries[query].asks;
  std::vector<std::string> all;
  for (const nets::Port& p : claim.nets->asked) all.push_back(p.name);
  return all;
}

// Adds what an engine said to one query.
void add(const Claim& claim, const Opinion& opinion, std::size_t query, Summary& all) {
  const Answer other = claim.wanted == Answer::sat ? Answer::unsat : Answer::sat;
  const Solved& solved = opinion.solved[query];
  const auto asks = asks_of(opinion.engine, claim, query);
  for (std::size_t i = 0; i < asks.size(); ++i) {
    const bool answered = i < solved.answers.size();
    const Answer answer = answered ? solved.answers[i] : solved.answer;
    if (answered && answer == claim.wanted) continue;
    all.as_wanted = false;
    all.opposite = all.opposite || (answered && answer == other);
    // What was stopped is said only where there is nothing else.
    if (answer == Answer::stopped && !all.text.empty()) continue;
    if (!all.text.empty() && answer != other && !all.stopped) continue;
    all.stopped = answer == Answer::stopped;
    all.text = fmt::format("{} ({})", to_text(answer), asks[i]);
    if (answer == Answer::failed) all.text += ": " + solved.said;
  }
}

Summary of_query(const Claim& claim, const Opinion& opinion, std::size_t query) {
  Summary one;
  add(claim, opinion, query, one);
  return one;
}

}  // namespace

Summary summary(const Claim& claim, const Opinion& opinion) {
  Summary all;
  for (std::size_t q = 0; q < opinion.solved.size(); ++q) add(claim, opinion, q, all);
  if (all.text.empty()) all.text = to_text(claim.wanted);
  return all;
}

Votes votes_on(const Claim& claim, const std::vector<Opinion>& opinions, std::size_t needed) {
  Votes votes;
  const std::size_t queries = std::max<std::size_t>(1, claim.queries.size());
  std::vector<std::size_t> yes(queries), no(queries);
  std::size_t nets_no = 0;
  for (const Opinion& o : opinions) {
    if (o.solved.empty()) continue;
    votes.against += summary(claim, o).opposite ? 1 : 0;
    const bool of_nets = o.engine == Engine::cec;
    for (std::size_t q = 0; q < queries; ++q) {
      if (!of_nets && q >= o.solved.size()) continue;
      const Summary one = of_query(claim, o, of_nets ? 0 : q);
      yes[q] += one.as_wanted ? 1 : 0;
      no[q] += one.opposite && !of_nets ? 1 : 0;
    }
    if (of_nets && of_query(claim, o, 0).opposite) ++nets_no;
  }
  votes.least = *std::min_element(yes.begin(), yes.end());
  votes.conflict = nets_no > 0 && votes.least > 0;
  for (std::size_t q = 0; q < queries; ++q) {
    votes.conflict = votes.conflict || (yes[q] > 0 && no[q] > 0);
    votes.enough.push_back(yes[q] >= needed);
  }
  votes.settled = votes.conflict || votes.against >= needed || votes.least >= needed;
  return votes;
}

const Solver& solver_of(Engine engine) {
  return *std::find_if(solvers().begin(), solvers().end(),
                       [&](const Solver& s) { return s.name == to_text(engine); });
}

}  // namespace cosim::proof
