// From cheap to dear: a few cases for all; of those left, a proof that they are the same machine;
// some more cases; the question whether one can be told apart from reset on, for a few seconds; all
// cases; that question again, for longer. What is decided is asked nothing more.
#include "tb/mutation/campaign.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <utility>

#include "model/core/input_error.h"
#include "tb/sim/report.h"
#include "tb/util/json.h"
#include "tb/util/parallel.h"
#include "tb/util/words.h"

namespace cosim::mutation {

using End = Outcome::End;

// In the order of Outcome::End.
constexpr std::array kEnds = {"open", "killed", "equivalent", "survived", "unread"};

void to_json(Json& json, End end) { json = kEnds[static_cast<std::size_t>(end)]; }
void to_json(Json& json, const Outcome& o) {
  json = {{"end", o.end}, {"stimulus", o.stimulus}, {"clock", o.clock}, {"signal", o.signal}};
}
namespace {

using Clock = std::chrono::steady_clock;

constexpr double most_seconds = 1e9;

Outcome outcome_from(const JsonAt& json) {
  const JsonAt end = json.at("end");
  const auto* const found = std::ranges::find(kEnds, end.text());
  if (found == kEnds.end()) end.fail("is no end of a mutant");
  return {static_cast<End>(found - kEnds.begin()), json.at("stimulus").text(),
          json.at("clock").whole(), json.at("signal").text()};
}

/// The campaign as it goes on, in step with its checkpoint.
class Course {
 public:
  Course(const Subject& subject, unsigned threads, Checkpoint& checkpoint, const Part& part)
      : subject_(subject), threads_(threads), checkpoint_(checkpoint) {
    const std::size_t all = subject.mutants().size();
    if (all == 0) throw InputError("yosys can plant no mutant in it");
    if (part.first > all) throw InputError("there is no such mutant");
    campaign_.first = part.first;
    campaign_.outcomes.resize(std::min<std::size_t>(part.count, all - part.first + 1));
    const auto state = checkpoint.state();
    if (!state) return;
    campaign_.seconds = state->at("seconds").number(0, most_seconds);
    const std::size_t mutants = campaign_.outcomes.size();
    const auto outcomes = state->at("outcomes").list(mutants, mutants);
    std::transform(outcomes.begin(), outcomes.end(), campaign_.outcomes.begin(), outcome_from);
  }

  /// Numbers of the mutants not yet decided.
  std::vector<unsigned> open() const {
    std::vector<unsigned> found;
    for (std::size_t i = 0; i < campaign_.outcomes.size(); ++i) {
      if (campaign_.outcomes[i].end == End::open) {
        found.push_back(static_cast<unsigned>(campaign_.first + i));
      }
    }
    return found;
  }

  void decide(unsigned mutant, Outcome outcome) {
    const std::lock_guard lock(guard_);
    campaign_.outcomes[mutant - campaign_.first] = std::move(outcome);
    if (checkpoint_.due()) save();
  }

  /// Calls work(mutant) for each of the mutants, some at a time.
  template <class Work>
  void each(const std::vector<unsigned>& mutants, const Work& work) {
    in_parallel(mutants.size(), threads_, [&](std::uint64_t i) {
      work(mutants[i]);
      return true;
    });
  }

  void attack_with(std::size_t first, std::size_t last) {
    begin("attacked");
    subject_.attack(open(), first, last, threads_,
                    [&](unsigned mutant, Outcome outcome) { decide(mutant, std::move(outcome)); });
    save();
  }

  void begin(std::string doing) {
    doing_ = std::move(doing);
    save();
  }

  void save() {
    campaign_.seconds += std::chrono::duration<double>(Clock::now() - counted_).count();
    counted_ = Clock::now();
    const std::string doing = fmt::format("{} of {} to be decided, {}", campaign_.count(End::open),
                                          count(campaign_.outcomes.size(), "mutant"), doing_);
    checkpoint_.save(
        {{"seconds", campaign_.seconds}, {"doing", doing}, {"outcomes", campaign_.outcomes}});
  }

  const Campaign& campaign() const { return campaign_; }

 private:
  const Subject& subject_;
  unsigned threads_;
  Checkpoint& checkpoint_;
  std::mutex guard_;  // of all below
  Campaign campaign_;
  std::string doing_;
  Clock::time_point counted_ = Clock::now();
};

}  // namespace

std::size_t Campaign::count(End end) const {
  return static_cast<std::size_t>(std::ranges::count(outcomes, end, &Outcome::end));
}

Campaign run_campaign(const Subject& subject, const Prover& prover, const Asker& asker,
                      unsigned threads, Checkpoint& checkpoint, const Part& part) {
  const std::size_t quick = subject.cases().quick, all = subject.cases().all.size();
  Course course(subject, threads, checkpoint, part);
  course.attack_with(0, quick);

  // A call begins with runs of yosys: some mutants a call, but few enough that little is lost.
  constexpr std::size_t a_call = 64;
  std::vector<std::vector<unsigned>> calls;
  for (const unsigned mutant : course.open()) {
    if (calls.empty() || calls.back().size() == a_call) calls.emplace_back();
    calls.back().push_back(mutant);
  }
  course.begin("asked of the engines");
  std::vector<unsigned> numbers(calls.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<unsigned>(i);
  course.each(numbers, [&](unsigned i) {
    const std::vector<bool> proved = prover(calls[i]);
    for (std::size_t k = 0; k < proved.size(); ++k) {
      if (proved[k]) course.decide(calls[i][k], {End::equivalent, "", 0, ""});
    }
  });
  course.save();

  // Most are settled in a second or two: longer than by some stimuli, sooner than by all of them.
  const std::size_t some = quick + (all - quick) / 8;
  constexpr std::chrono::seconds soon(3), longest(60);
  const auto ask_each = [&](std::chrono::seconds limit) {
    course.begin(fmt::format("asked from reset, at most {} s each", limit.count()));
    course.each(course.open(),
                [&](unsigned mutant) { course.decide(mutant, asker(mutant, limit)); });
    course.save();
  };
  course.attack_with(quick, some);
  ask_each(soon);
  course.attack_with(some, all);
  ask_each(longest);
  for (const unsigned mutant : course.open()) course.decide(mutant, {End::survived, "", 0, ""});
  return course.campaign();
}

std::string to_json(const Subject& subject, const Campaign& campaign) {
  Json top;
  top["design"] = subject.bench().design();
  top["parameters"] = parameters(subject.bench());
  top["mutants"] = campaign.outcomes.size();
  top["killed"] = campaign.count(End::killed);
  top["equivalent"] = campaign.count(End::equivalent);
  top["survived"] = campaign.count(End::survived);
  top["unread"] = campaign.count(End::unread);
  top["seconds"] = campaign.seconds;
  top["outcomes"] = Json::array();
  for (std::size_t i = 0; i < campaign.outcomes.size(); ++i) {
    const Outcome& o = campaign.outcomes[i];
    const std::size_t mutant = campaign.first + i;
    Json one{{"mutant", mutant}, {"what", subject.mutants()[mutant - 1]}, {"end", o.end}};
    if (o.end == End::killed) {
      one["stimulus"] = o.stimulus;
      one["clock"] = o.clock;
      one["signal"] = o.signal;
    }
    top["outcomes"].push_back(std::move(one));
  }
  return json_text(top, 1) + '\n';
}

}  // namespace cosim::mutation
