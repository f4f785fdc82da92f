#include "tb/proof/decide.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/proof/abc.h"
#include "tb/support/parallel.h"
#include "tb/support/words.h"

namespace cosim::proof {
namespace {

// One engine's answers to one claim.
struct Summary {
  bool as_wanted = true;
  bool opposite = false;
  std::string text;  // of the first answer that is not as wanted
};

const Solver& solver_of(Engine engine) {
  return *std::find_if(solvers().begin(), solvers().end(),
                       [&](const Solver& s) { return s.name == to_text(engine); });
}

// What is asked in one query: of nets in all.
std::vector<std::string> asks_of(Engine engine, const Claim& claim, std::size_t query) {
  if (engine != Engine::cec) return claim.queries[query].asks;
  std::vector<std::string> all;
  for (const nets::Port& p : claim.nets->asked) all.push_back(p.name);
  return all;
}

Summary summary(const Claim& claim, const Opinion& opinion) {
  Summary all;
  const Answer other = claim.wanted == Answer::sat ? Answer::unsat : Answer::sat;
  for (std::size_t q = 0; q < opinion.solved.size(); ++q) {
    const Solved& solved = opinion.solved[q];
    const auto asks = asks_of(opinion.engine, claim, q);
    for (std::size_t i = 0; i < asks.size(); ++i) {
      const bool answered = i < solved.answers.size();
      const Answer answer = answered ? solved.answers[i] : solved.answer;
      if (answered && answer == claim.wanted) continue;
      all.as_wanted = false;
      all.opposite = all.opposite || (answered && answer == other);
      if (!all.text.empty() && answer != other) continue;
      all.text = fmt::format("{} ({})", to_text(answer), asks[i]);
      if (answer == Answer::failed) all.text += ": " + solved.said;
    }
  }
  if (all.text.empty()) all.text = to_text(claim.wanted);
  return all;
}

// Whether more opinions would change nothing.
bool is_settled(const Claim& claim, const std::vector<Opinion>& opinions, std::size_t needed) {
  std::size_t yes = 0, no = 0;
  for (const Opinion& o : opinions) {
    const Summary s = summary(claim, o);
    yes += s.as_wanted ? 1 : 0;
    no += s.opposite ? 1 : 0;
  }
  return yes >= needed || no >= needed || (yes > 0 && no > 0);
}

}  // namespace

std::string to_text(Engine engine) {
  switch (engine) {
    case Engine::cec:
      return "cec";
    case Engine::cvc5:
      return "cvc5";
    case Engine::z3:
      return "z3";
  }
  return "";
}

std::string program_of(Engine engine) {
  return engine == Engine::cec ? "yosys-abc" : to_text(engine);
}

std::vector<Engine> all_engines() { return {Engine::cec, Engine::z3, Engine::cvc5}; }

std::string listed(const std::vector<Engine>& engines) {
  std::string text;
  for (std::size_t i = 0; i < engines.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == engines.size() ? " and " : ", ") + to_text(engines[i]);
  }
  return text;
}

std::vector<Engine> engines_of(const std::string& list, const std::vector<Engine>& all) {
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

bool can_ask(Engine engine, const Claim& claim) {
  return engine == Engine::cec ? claim.nets != nullptr : !claim.queries.empty();
}

double Opinion::seconds() const {
  double all = 0;
  for (const Solved& s : solved) all += s.seconds;
  return all;
}

Decision judged(const Claim& claim, std::vector<Opinion> opinions, std::size_t needed) {
  Decision d;
  std::size_t yes = 0, no = 0;
  std::string answers, unanswered;
  for (const Opinion& o : opinions) {
    const Summary s = summary(claim, o);
    yes += s.as_wanted ? 1 : 0;
    no += s.opposite ? 1 : 0;
    const std::string says = fmt::format(", {} {}", to_text(o.engine), s.text);
    answers += says;
    if (!s.as_wanted) unanswered += says;
  }
  answers.erase(0, 2);
  d.proved = no == 0 && yes >= needed;
  d.refuted = no > 0 && yes == 0;
  if (d.proved) {
    d.verdict = "proved" + unanswered;
  } else if (d.refuted) {
    d.verdict = "REFUTED: " + answers;
  } else if (yes > 0 && no > 0) {
    d.verdict = "THE ENGINES DISAGREE: " + answers;
  } else {
    d.verdict = fmt::format("UNDECIDED, {} of {}: {}", yes, needed,
                            answers.empty() ? "no engine can be asked" : answers);
  }
  d.opinions = std::move(opinions);
  return d;
}

std::vector<Decision> decide(const std::vector<const Claim*>& claims, const Asking& asking) {
  const std::size_t needed = std::min<std::size_t>(asking.engines.size(), 2);
  struct Asked {
    std::size_t claim, opinion, query;
    std::size_t size;  // of what is asked, a measure of the time it takes
  };
  std::vector<std::vector<Opinion>> opinions(claims.size());
  std::vector<std::size_t> next(claims.size());  // of the engines
  for (;;) {
    std::vector<Asked> work;
    for (std::size_t c = 0; c < claims.size(); ++c) {
      const Claim& claim = *claims[c];
      if (is_settled(claim, opinions[c], needed)) continue;
      std::size_t more = opinions[c].size() < needed ? needed - opinions[c].size() : 1;
      for (; more > 0 && next[c] < asking.engines.size(); ++next[c]) {
        const Engine engine = asking.engines[next[c]];
        if (!can_ask(engine, claim)) continue;
        --more;
        const bool of_nets = engine == Engine::cec;
        const std::size_t queries = of_nets ? 1 : claim.queries.size();
        for (std::size_t q = 0; q < queries; ++q) {
          constexpr std::size_t of_a_gate = 40;  // characters in a script
          work.push_back({c, opinions[c].size(), q,
                          of_nets ? of_a_gate * claim.nets->graph.gates().size()
                                  : claim.queries[q].script.size()});
        }
        opinions[c].push_back({engine, std::vector<Solved>(queries)});
      }
    }
    if (work.empty()) break;
    // The longest first, so that none is waited for at the end.
    std::stable_sort(work.begin(), work.end(),
                     [](const Asked& a, const Asked& b) { return a.size > b.size; });
    in_parallel(work.size(), asking.jobs, [&](std::uint64_t i) {
      const Asked& question = work[i];
      const Claim& claim = *claims[question.claim];
      Opinion& opinion = opinions[question.claim][question.opinion];
      Solved& solved = opinion.solved[question.query];
      if (opinion.engine == Engine::cec) {
        solved = solve(*claim.nets, asking.limit);
      } else {
        const Query& query = claim.queries[question.query];
        solved = solve(solver_of(opinion.engine), query.script, asking.limit, query.eager);
      }
      return true;
    });
  }
  std::vector<Decision> all;
  for (std::size_t c = 0; c < claims.size(); ++c) {
    all.push_back(judged(*claims[c], std::move(opinions[c]), needed));
  }
  return all;
}

bool timed_out(const std::vector<Decision>& decisions) {
  for (const Decision& d : decisions) {
    for (const Opinion& o : d.opinions) {
      for (const Solved& s : o.solved) {
        if (s.answer == Answer::timed_out) return true;
      }
    }
  }
  return false;
}

std::map<std::string, std::string> refuting_values(const Claim& claim, const Decision& decision,
                                                   int limit) {
  for (const Opinion& o : decision.opinions) {
    for (std::size_t q = 0; q < o.solved.size(); ++q) {
      if (o.solved[q].answer != Answer::sat) continue;
      auto found = o.engine == Engine::cec
                       ? o.solved[q].values
                       : values(solver_of(o.engine), claim.queries[q].script, claim.terms, limit);
      if (!found.empty()) return found;
    }
  }
  return {};
}

}  // namespace cosim::proof
