#include "tb/proof/decide.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "tb/util/parallel.h"

namespace cosim::proof {
namespace {

// What an engine said of a claim in all.
struct Summary {
  bool as_wanted = true, opposite = false;
  std::string text;  // of the first answer that is not as wanted
};
Summary summary(const Claim& claim, const Opinion& opinion) {
  const Answer other = claim.wanted == Answer::sat ? Answer::unsat : Answer::sat;
  const Solved& solved = opinion.solved;
  Summary all;
  for (std::size_t i = 0; i < claim.questions.asked.size(); ++i) {
    const Answer answer = i < solved.answers.size() ? solved.answers[i] : solved.answer;
    if (i < solved.answers.size() && answer == claim.wanted) continue;
    const bool is_opposite = i < solved.answers.size() && answer == other;
    if (all.text.empty() || (is_opposite && !all.opposite)) {
      all.text = fmt::format("{} ({})", to_text(answer), claim.questions.asked[i].name);
      if (answer == Answer::failed) all.text += ": " + solved.said;
    }
    all.as_wanted = false;
    all.opposite = all.opposite || is_opposite;
  }
  if (all.text.empty()) all.text = to_text(claim.wanted);
  return all;
}

// That something can be is shown by one: what it finds is tried on the gates.
std::vector<Engine> engines_for(const Claim& claim, const Asking& asking) {
  if (claim.questions.asked.empty()) return {};
  if (claim.wanted == Answer::unsat) return asking.engines;
  const bool is_there = std::ranges::find(asking.engines, Engine::cadical) != asking.engines.end();
  return {is_there ? Engine::cadical : asking.engines.front()};
}

}  // namespace

Decision judged(const Claim& claim, std::vector<Opinion> opinions) {
  Decision d;
  std::size_t as_wanted = 0, against = 0;
  std::string answers;
  for (const Opinion& o : opinions) {
    const Summary s = summary(claim, o);
    as_wanted += s.as_wanted ? 1 : 0;
    against += s.opposite ? 1 : 0;
    if (o.solved.answer == Answer::stopped && !s.opposite) continue;
    answers += fmt::format("{}{} {}", answers.empty() ? "" : ", ", to_text(o.engine), s.text);
  }
  d.disagree = as_wanted > 0 && against > 0;
  d.refuted = against > 0 && !d.disagree;
  d.proved = !opinions.empty() && as_wanted == opinions.size();
  d.verdict = d.proved     ? "proved"
              : d.refuted  ? "REFUTED: " + answers
              : d.disagree ? "THE ENGINES DISAGREE: " + answers
              : opinions.empty()
                  ? "UNDECIDED: no engine can be asked"
                  : fmt::format("UNDECIDED, {} of {}: {}", as_wanted, opinions.size(), answers);
  d.opinions = std::move(opinions);
  return d;
}

std::vector<Decision> decide(const std::vector<const Claim*>& claims, const Asking& asking,
                             const Told& told) {
  struct Course {
    std::vector<Opinion> opinions;
    std::size_t open = 0;
    std::atomic<bool> no_more = false;
  };
  std::vector<std::unique_ptr<Course>> courses;
  std::vector<Decision> all(claims.size());
  for (std::size_t c = 0; c < claims.size(); ++c) {
    Course& course = *courses.emplace_back(std::make_unique<Course>());
    for (const Engine e : engines_for(*claims[c], asking)) course.opinions.push_back({e});
    course.open = course.opinions.size();
    if (course.open > 0) continue;
    all[c] = judged(*claims[c], {});
    told(c, all[c]);
  }
  std::mutex guard;
  const std::size_t engines = asking.engines.size();
  in_parallel(claims.size() * engines, asking.jobs, [&](std::uint64_t i) {
    const std::size_t c = i / engines;
    Course& course = *courses[c];
    if (i % engines >= course.opinions.size()) return true;
    Opinion& own = course.opinions[i % engines];
    own.solved.answer = Answer::stopped;
    Solved solved = own.solved;
    if (!course.no_more) {
      solved = solve(own.engine, claims[c]->questions, asking.limit, &course.no_more);
    }
    const std::scoped_lock lock(guard);
    own.solved = std::move(solved);
    if (summary(*claims[c], own).opposite) course.no_more = true;
    if (--course.open > 0) return true;
    all[c] = judged(*claims[c], course.opinions);
    told(c, all[c]);
    return true;
  });
  return all;
}

bool timed_out(const std::vector<Decision>& decisions) {
  for (const Decision& d : decisions) {
    for (const Opinion& o : d.opinions) {
      if (o.solved.answer == Answer::timed_out) return true;
    }
  }
  return false;
}

std::map<std::string, Word> refuting_values(const Decision& decision) {
  for (const Opinion& o : decision.opinions) {
    if (!o.solved.values.empty()) return o.solved.values;
  }
  return {};
}

}  // namespace cosim::proof
