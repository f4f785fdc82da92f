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
    std::size_t claim = 0, opinion = 0, question = 0;
    int seconds = 1;
    std::size_t size = 0;  // of what is asked, a measure of the time it takes
  };
  struct Course {
    std::vector<Opinion> opinions;
    std::vector<std::vector<bool>> begun;              // by opinion and question
    std::deque<std::deque<std::atomic<bool>>> enough;  // likewise: no answer is needed any more
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

  static std::size_t questions(Engine engine, const Claim& claim) {
    return engine == Engine::cec ? 1 : claim.queries.size();
  }

  bool begin(std::size_t c, std::size_t opinion, std::size_t question) {
    Course& course = courses_[c];
    if (course.begun[opinion][question] || course.enough[opinion][question]) return false;
    course.begun[opinion][question] = true;
    constexpr std::size_t of_a_gate = 40;  // characters in a script
    const Claim& claim = *claims_[c];
    const std::size_t size = course.opinions[opinion].engine == Engine::cec
                                 ? of_a_gate * claim.nets->graph.gates().size()
                                 : claim.queries[question].script.size();
    pending_.push_back({c, opinion, question, std::min(asking_.slice, asking_.limit), size});
    return true;
  }

  // The first engine that has not begun, on what is not answered; on one question of the scripts
  // alone, where that is given.
  bool begin_next(std::size_t c, const std::size_t* question = nullptr) {
    const Course& course = courses_[c];
    for (std::size_t o = 0; o < course.opinions.size(); ++o) {
      bool any = false;
      for (std::size_t q = 0; q < course.opinions[o].solved.size(); ++q) {
        const bool of_scripts = course.opinions[o].engine != Engine::cec;
        if (question != nullptr && of_scripts && q != *question) continue;
        any = begin(c, o, q) || any;
      }
      if (any) return true;
    }
    return false;
  }

  bool take(Try& next) {
    const std::scoped_lock lock(guard_);
    std::erase_if(pending_, [&](const Try& t) {
      return bool{courses_[t.claim].enough[t.opinion][t.question]};
    });
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

  Solved ask(const Try& t) {
    const Claim& claim = *claims_[t.claim];
    Course& course = courses_[t.claim];
    const Engine engine = course.opinions[t.opinion].engine;
    const std::atomic<bool>* enough = &course.enough[t.opinion][t.question];
    if (engine == Engine::cec) return solve(*claim.nets, t.seconds, enough);
    const Query& query = claim.queries[t.question];
    return solve(solver_of(engine), query.script, t.seconds, query.eager, enough);
  }

  void put(const Try& t, Solved solved) {
    const std::scoped_lock lock(guard_);
    Course& course = courses_[t.claim];
    Solved& own = course.opinions[t.opinion].solved[t.question];
    solved.seconds += own.seconds;
    own = std::move(solved);
    const bool answered = own.answer == Answer::sat || own.answer == Answer::unsat;
    if (own.answer == Answer::timed_out && t.seconds < asking_.limit) {
      own.answer = Answer::stopped;  // till it is asked again
      pending_.push_back(t);
      pending_.back().seconds = std::min(kLonger * t.seconds, asking_.limit);
    }
    if (!answered) {
      const bool of_scripts = course.opinions[t.opinion].engine != Engine::cec;
      begin_next(t.claim, of_scripts ? &t.question : nullptr);
    }
    stop_enough(t.claim);
    const auto waits = [&](const Try& one) { return one.claim == t.claim; };
    if (--course.running > 0) return;
    if (course.is_settled ||
        (std::none_of(pending_.begin(), pending_.end(), waits) && !begin_next(t.claim)))
      tell(t.claim);
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
