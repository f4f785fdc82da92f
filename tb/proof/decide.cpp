#include "tb/proof/decide.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "model/core/input_error.h"
#include "tb/proof/race.h"
#include "tb/proof/votes.h"
#include "tb/support/words.h"

namespace cosim::proof {

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
  const Votes votes = votes_on(claim, opinions, needed);
  std::string answers, unanswered;
  for (const Opinion& o : opinions) {
    const Summary s = summary(claim, o);
    const std::string says = fmt::format(", {} {}", to_text(o.engine), s.text);
    answers += says;
    if (!s.as_wanted && !s.stopped) unanswered += says;
  }
  answers.erase(0, std::min<std::size_t>(2, answers.size()));
  d.proved = votes.against == 0 && votes.least >= needed;
  d.refuted = votes.against > 0 && !votes.conflict;
  d.disagree = votes.conflict;
  if (d.proved) {
    d.verdict = "proved" + unanswered;
  } else if (d.refuted) {
    d.verdict = "REFUTED: " + answers;
  } else if (d.disagree) {
    d.verdict = "THE ENGINES DISAGREE: " + answers;
  } else {
    d.verdict = fmt::format("UNDECIDED, {} of {}: {}", votes.least, needed,
                            answers.empty() ? "no engine can be asked" : answers);
  }
  d.opinions = std::move(opinions);
  return d;
}

std::vector<Decision> decide(const std::vector<const Claim*>& claims, const Asking& asking,
                             const Told& told) {
  const std::size_t needed = std::min<std::size_t>(asking.engines.size(), 2);
  std::vector<Decision> all(claims.size());
  race(claims, asking, needed, [&](std::size_t c, std::vector<Opinion> opinions) {
    all[c] = judged(*claims[c], std::move(opinions), needed);
    told(c, all[c]);
  });
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
