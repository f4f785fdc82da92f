// A question goes to as many engines as must agree, and each try has a slice of time. What a slice
// did not decide goes to another engine, and then to all of them anew with four times the time; so
// one that never answers holds up none that would (a portfolio, as of SAT solvers). Where a thread
// has nothing else to do the other engines begin at once. Who has not answered when enough have is
// stopped.
#include "tb/proof/race.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <mutex>
#include <utility>

#include "tb/proof/abc.h"
#include "tb/proof/votes.h"
#include "tb/support/parallel.h"

namespace cosim::proof {
namespace {

constexpr int kLonger = 4;  // how much more time the next try has

class Race {
 public:
  Race(const std::vector<const Claim*>& claims, const Asking& asking, std::size_t needed,
       const ToldClaim& told)
      : claims_(claims), asking_(asking), needed_(needed), told_(told), courses_(claims.size()) {
    for (std::size_t c = 0; c < claims.size(); ++c) {
      Course& course = courses_[c];
      for (const Engine e : asking.engines) {
        if (!can_ask(e, *claims[c])) continue;
        course.opinions.push_back({e, std::vector<Solved>(questions(e, *claims[c]))});
        for (Solved& s : course.opinions.back().solved) s.answer = Answer::stopped;
      }
      course.begun.resize(course.opinions.size());
      for (std::size_t i = 0; i < course.opinions.size(); ++i) {
        course.begun[i].resize(course.opinions[i].solved.size());
        course.enough.emplace_back(course.opinions[i].solved.size());
        course.all_enough.emplace_back(false);
      }
      for (std::size_t n = 0; n < needed; ++n) begin_next(c);
    }
  }

  // Each thread has an engine answer until none is left to be asked.
  void run() {
    in_parallel(asking_.jobs, asking_.jobs, [&](std::uint64_t) {
      for (Try next; take(next);) put(next, ask(next));
      return true;
    });
    for (std::size_t c = 0; c < claims_.size(); ++c) tell(c);  // those that nobody can be asked
  }

 private:
  struct Try {
    std::size_t claim = 0, opinion = 0;
    std::vector<std::size_t> questions{};
    int seconds = 1;
    std::size_t size = 0;  // of what is asked, a measure of the time it takes
  };
  struct Course {
    std::vector<Opinion> opinions;
    std::vector<std::vector<bool>> begun;              // by opinion and question
    std::deque<std::deque<std::atomic<bool>>> enough;  // likewise: no answer is needed any more
    std::deque<std::atomic<bool>> all_enough;          // by opinion: of no question
    bool is_settled = false, is_told = false;
    int running = 0;
  };

  void tell(std::size_t c) {
    if (std::exchange(courses_[c].is_told, true)) return;
    std::vector<Opinion> opinions = courses_[c].opinions;
    std::erase_if(opinions, [](const Opinion& o) {
      return std::all_of(o.solved.begin(), o.solved.end(),
                         [](const Solved& s) { return s.answer == Answer::stopped; });
    });
    told_(c, std::move(opinions));
  }

  static bool takes_many(Engine engine) {
    return engine != Engine::cec && solver_of(engine).takes_many;
  }
  static std::size_t questions(Engine engine, const Claim& claim) {
    return engine == Engine::cec ? 1 : claim.queries.size();
  }

  // One of these after the other, or at a time where the engine takes many.
  bool begin(std::size_t c, std::size_t opinion, std::vector<std::size_t> questions) {
    Course& course = courses_[c];
    const Engine engine = course.opinions[opinion].engine;
    std::erase_if(questions, [&](std::size_t q) {
      return course.begun[opinion][q] || course.enough[opinion][q];
    });
    if (questions.empty()) return false;
    for (const std::size_t q : questions) course.begun[opinion][q] = true;
    if (takes_many(engine)) {
      put_off(c, opinion, questions, asking_.slice);
    } else {
      for (const std::size_t q : questions) put_off(c, opinion, {q}, asking_.slice);
    }
    return true;
  }
  void put_off(std::size_t c, std::size_t opinion, const std::vector<std::size_t>& questions,
               int seconds) {
    constexpr std::size_t of_a_gate = 40;  // characters in a script
    const Claim& claim = *claims_[c];
    const bool is_nets = courses_[c].opinions[opinion].engine == Engine::cec;
    std::size_t size = is_nets ? of_a_gate * claim.nets->graph.gates().size() : 0;
    for (const std::size_t q : questions) size += is_nets ? 0 : claim.queries[q].script.size();
    pending_.push_back({c, opinion, questions, std::min(seconds, asking_.limit), size});
  }

  // The first engine that has not begun, on what is not answered; on one question of the scripts
  // alone, where that is given.
  bool begin_next(std::size_t c, const std::size_t* question = nullptr) {
    const Course& course = courses_[c];
    for (std::size_t o = 0; o < course.opinions.size(); ++o) {
      const bool of_scripts = course.opinions[o].engine != Engine::cec;
      std::vector<std::size_t> questions;
      for (std::size_t q = 0; q < course.opinions[o].solved.size(); ++q) {
        if (question == nullptr || !of_scripts || q == *question) questions.push_back(q);
      }
      if (begin(c, o, std::move(questions))) return true;
    }
    return false;
  }

  bool take(Try& next) {
    const std::scoped_lock lock(guard_);
    for (Try& t : pending_) {
      std::erase_if(t.questions,
                    [&](std::size_t q) { return bool{courses_[t.claim].enough[t.opinion][q]}; });
    }
    std::erase_if(pending_, [](const Try& t) { return t.questions.empty(); });
    for (std::size_t c = 0; pending_.empty() && c < claims_.size(); ++c) {
      if (!courses_[c].is_settled) begin_next(c);
    }
    if (pending_.empty()) return false;
    // The shortest slices first; of these the longest work, so that none is waited for at the end.
    const auto at =
        std::min_element(pending_.begin(), pending_.end(), [](const Try& a, const Try& b) {
          return a.seconds != b.seconds ? a.seconds < b.seconds : a.size > b.size;
        });
    next = *at;
    pending_.erase(at);
    ++courses_[next.claim].running;
    return true;
  }

  std::vector<Solved> ask(const Try& t) {
    const Claim& claim = *claims_[t.claim];
    Course& course = courses_[t.claim];
    const Engine engine = course.opinions[t.opinion].engine;
    if (t.questions.size() > 1) {
      std::vector<std::string> scripts;
      for (const std::size_t q : t.questions) scripts.push_back(claim.queries[q].script);
      return solve_all(solver_of(engine), scripts, t.seconds, &course.all_enough[t.opinion]);
    }
    const std::size_t question = t.questions.front();
    const std::atomic<bool>* enough = &course.enough[t.opinion][question];
    if (engine == Engine::cec) return {solve(*claim.nets, t.seconds, enough)};
    return {solve(solver_of(engine), claim.queries[question].script, t.seconds, enough)};
  }

  void put(const Try& t, std::vector<Solved> all) {
    const std::scoped_lock lock(guard_);
    for (std::size_t i = 0; i < all.size(); ++i) put(t, t.questions[i], std::move(all[i]));
    stop_enough(t.claim);
    Course& course = courses_[t.claim];
    const auto waits = [&](const Try& one) { return one.claim == t.claim; };
    if (--course.running > 0) return;
    if (course.is_settled ||
        (std::none_of(pending_.begin(), pending_.end(), waits) && !begin_next(t.claim)))
      tell(t.claim);
  }
  void put(const Try& t, std::size_t question, Solved solved) {
    const Opinion& opinion = courses_[t.claim].opinions[t.opinion];
    Solved& own = courses_[t.claim].opinions[t.opinion].solved[question];
    solved.seconds += own.seconds;
    own = std::move(solved);
    if (own.answer == Answer::sat || own.answer == Answer::unsat) return;
    const bool was_alone = t.questions.size() == 1;
    const bool was_too_long = own.answer == Answer::timed_out;
    if (!was_alone && (was_too_long || own.answer == Answer::failed)) {
      own.answer = Answer::stopped;  // by what stood before it; till it is asked again, alone
      put_off(t.claim, t.opinion, {question}, was_too_long ? kLonger * t.seconds : t.seconds);
      if (was_too_long) begin_next(t.claim, &question);
      return;
    }
    if (was_too_long && t.seconds < asking_.limit) {
      own.answer = Answer::stopped;  // till it is asked again
      put_off(t.claim, t.opinion, {question}, kLonger * t.seconds);
    }
    begin_next(t.claim, opinion.engine != Engine::cec ? &question : nullptr);
  }

  // Tells those that need not answer any more.
  void stop_enough(std::size_t c) {
    Course& course = courses_[c];
    const Votes votes = votes_on(*claims_[c], course.opinions, needed_);
    for (std::size_t o = 0; o < course.opinions.size(); ++o) {
      const bool of_scripts = course.opinions[o].engine != Engine::cec;
      for (std::size_t q = 0; q < course.enough[o].size(); ++q) {
        if (votes.settled || (of_scripts && votes.enough[q])) course.enough[o][q] = true;
      }
      course.all_enough[o] = std::all_of(course.enough[o].begin(), course.enough[o].end(),
                                         [](const auto& is) -> bool { return is; });
    }
    course.is_settled = course.is_settled || votes.settled;
  }

  const std::vector<const Claim*>& claims_;
  const Asking& asking_;
  std::size_t needed_;
  const ToldClaim& told_;
  std::mutex guard_;
  std::vector<Course> courses_;
  std::vector<Try> pending_;
};

}  // namespace

void race(const std::vector<const Claim*>& claims, const Asking& asking, std::size_t needed,
          const ToldClaim& told) {
  Race(claims, asking, needed, told).run();
}

}  // namespace cosim::proof
