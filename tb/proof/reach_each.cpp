// What ternary simulation shows to be impossible is done with first, the most of it bits that are
// constants. All that is left is asked as one question, whether any of it ever happens. A stimulus
// is run, and whatever it reaches is done with; a proof is one of all at once. Where the engine
// does not come to an end in its share of the time, the question is cut in two halves: what is hard
// is so told from what is easy, and before that what stays as it is by one step of induction.
// Asking for each by itself took a run of the engine for each bit of a counter.
#include "tb/proof/reach_each.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "tb/nets/possible.h"
#include "tb/nets/runs.h"
#include "tb/proof/correspondence.h"

namespace cosim::proof {
namespace {

using Clock = std::chrono::steady_clock;
using Some = std::vector<std::size_t>;  // points, by their numbers

constexpr auto kLeastTime = std::chrono::seconds(2);  // for one question

class Rounds {
 public:
  Rounds(const nets::Graph& graph, const nets::Bits& points)
      : graph_(graph), lits_(points), is_done_(points.size()) {
    all_.points.resize(points.size());
  }

  ReachedEach run(Clock::time_point until, unsigned jobs,
                  const std::function<void(std::size_t)>& left) {
    Some every(lits_.size());
    for (std::size_t i = 0; i < every.size(); ++i) every[i] = i;
    const auto values = nets::possible(graph_);
    for (const std::size_t i : every) {
      if (!values[lits_[i].gate()].inverted(lits_[i].is_inverted()).one) never(i);
    }
    questions_.push_back(std::move(every));
    while (!questions_.empty() && Clock::now() < until) {
      left(static_cast<std::size_t>(std::count(is_done_.begin(), is_done_.end(), false)));
      Some some = std::move(questions_.front());
      questions_.pop_front();
      std::erase_if(some, [&](std::size_t i) -> bool { return is_done_[i]; });
      if (some.empty()) continue;
      const auto share = (until - Clock::now()) / static_cast<int>(2 * (questions_.size() + 1));
      const auto ends =
          std::min(until, Clock::now() + std::max<Clock::duration>(kLeastTime, share));
      answered(some, reach_any(some, ends, jobs), until);
    }
    return std::move(all_);
  }

 private:
  nets::Bit any_of(nets::Graph& graph, const Some& some) const {
    nets::Bit any = nets::no;
    for (const std::size_t i : some) any = graph.or_of(any, lits_[i]);
    return any;
  }

  Reached reach_any(const Some& some, Clock::time_point ends, unsigned jobs) const {
    nets::Graph graph = graph_;
    const nets::Bit any = any_of(graph, some);
    return reach(graph, any, ends, jobs);
  }

  // What one step of induction says of all together is known of each.
  void find_constant(const Some& some, Clock::time_point until) {
    nets::Graph graph = graph_;
    const nets::Bit any = any_of(graph, some);
    const auto same = corresponding(graph, any, Clock::now() + (until - Clock::now()) / 2);
    for (const std::size_t i : some) {
      if (same && placed_at(*same, lits_[i]) == nets::no) never(i);
    }
  }

  void never(std::size_t point) {
    all_.points[point].ever = Ever::never;
    is_done_[point] = true;
  }

  void answered(const Some& some, const Reached& reached, Clock::time_point until) {
    switch (reached.ever) {
      case Ever::yes:
        take(reached.inputs);
        return questions_.push_front(some);
      case Ever::never:
        for (const std::size_t i : some) never(i);
        return;
      case Ever::open:
        for (const std::size_t i : some) {
          all_.points[i].clocks = std::max(all_.points[i].clocks, reached.clocks);
        }
        if (some.size() == 1) return;
        if (!std::exchange(knows_constant_, true)) find_constant(some, until);
        const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
        questions_.emplace_back(some.begin(), middle);
        questions_.emplace_back(middle, some.end());
    }
  }

  void take(const std::vector<std::vector<bool>>& inputs) {
    std::vector<bool> is_seen(lits_.size());
    for (const auto& row : nets::traced(graph_, inputs, lits_)) {
      for (std::size_t i = 0; i < row.size(); ++i) is_seen[i] = is_seen[i] || row[i];
    }
    for (std::size_t i = 0; i < is_seen.size(); ++i) {
      if (!is_seen[i] || is_done_[i]) continue;
      all_.points[i] = {Ever::yes, all_.stimuli.size(), 0};
      is_done_[i] = true;
    }
    all_.stimuli.push_back(inputs);
  }

  const nets::Graph& graph_;
  const nets::Bits& lits_;
  std::vector<bool> is_done_;
  std::deque<Some> questions_;
  bool knows_constant_ = false;
  ReachedEach all_;
};

}  // namespace

ReachedEach reach_each(const nets::Graph& graph, const nets::Bits& points,
                       std::chrono::steady_clock::time_point until, unsigned jobs,
                       const std::function<void(std::size_t)>& left) {
  return Rounds(graph, points).run(until, jobs, left);
}

}  // namespace cosim::proof
