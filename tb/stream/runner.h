// What runs cases on one instance of the RTL, one after the other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "tb/stream/dut.h"
#include "tb/stream/run.h"
#include "tb/stream/shape.h"
#include "tb/stream/sides.h"
#include "tb/util/random.h"

namespace cosim {

/// Which of a design's clocks take their edge, for stimulus of streams. Each has a period and a
/// next edge, as in an event-driven simulator; a step is the next time at which any has one. The
/// periods are drawn anew for each stretch of steps: all in phase; nearly the same, which drift
/// past each other; of ratios up to 32; or as they were, while one clock stands still. So each
/// order of edges comes, and each clock goes on in the end.
class EdgesDrawn {
 public:
  /// Of so many clocks, from 2 on.
  explicit EdgesDrawn(std::size_t clocks)
      : edges_(clocks), periods_(clocks, 1), next_(clocks), were_(clocks) {}

  void start(std::uint64_t seed) {
    random_ = Random(seed);
    std::fill(next_.begin(), next_.end(), 0);
    std::fill(were_.begin(), were_.end(), 0);
    steps_ = 0;
  }
  /// One more step; gives of each clock 1 where it takes its edge, which some does.
  const std::vector<Word>& step() {
    if (steps_ == 0) begin_stretch();
    --steps_;
    std::uint64_t now = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t c = 0; c < next_.size(); ++c) {
      if (c != still_) now = std::min(now, next_[c]);
    }
    if (all_were()) std::fill(were_.begin(), were_.end(), 0);
    for (std::size_t c = 0; c < next_.size(); ++c) {
      edges_[c] = c != still_ && next_[c] == now ? 1 : 0;
      if (edges_[c] != 0) next_[c] += periods_[c];
      were_[c] |= edges_[c];
    }
    return edges_;
  }
  const std::vector<Word>& edges() const { return edges_; }
  /// Each clock has had one since this last was so.
  bool all_were() const {
    return std::ranges::all_of(were_, [](Word were) { return were != 0; });
  }

 private:
  void begin_stretch() {
    constexpr std::uint64_t longest = 64;
    steps_ = 1 + random_.below(longest);
    const std::uint64_t from = *std::max_element(next_.begin(), next_.end());
    const std::uint64_t kind = random_.below(4);
    still_ = kind == 0 ? random_.below(next_.size()) : next_.size();
    for (std::size_t c = 0; c < next_.size(); ++c) {
      // Behind a stretch without it no edge lies in the past.
      next_[c] = std::max(next_[c], from);
      if (kind == 1) periods_[c] = 1;
      if (kind == 2) periods_[c] = 16 + random_.below(4);
      if (kind == 3) periods_[c] = std::uint64_t{1} << random_.below(6);
      if (kind > 1) next_[c] += random_.below(periods_[c]);
    }
  }

  Random random_{0};
  std::vector<Word> edges_;
  std::vector<std::uint64_t> periods_, next_;
  std::vector<Word> were_;   // since all were
  std::uint64_t steps_ = 0;  // left of the stretch
  std::size_t still_ = 0;    // the clock that stands still, or none
};

/// It finds the ports once, and keeps its memory from case to case.
class StreamRunner {
 public:
  /// Both outlive it. InputError where the RTL has other ports.
  StreamRunner(const StreamShape& shape, StreamDut& dut);
  StreamRunner(const StreamRunner&) = delete;
  StreamRunner& operator=(const StreamRunner&) = delete;

  /// The instance has just powered up. After the last transaction some clocks are waited for one
  /// too many: 16 more than the longest time for which nothing moved before.
  StreamResult run(const StreamOrder& order);

 private:
  using Kind = StreamFinding::Kind;

  void start();
  template <bool plain>
  void set_clocks(bool after);
  void draw_edges();
  void reset();
  template <bool plain>
  void run_clocks();
  template <bool plain>
  bool clock();
  void note_taken();
  void found(Kind kind, bool goes_in, std::size_t stream, std::size_t number, std::size_t cell = 0);
  void answer();
  void eval();
  void hear();
  template <bool plain>
  void judge(Taker& t);
  void judge_steady(const Taker& t);
  void judge_value(const Taker& t);
  void judge_latency(Taker& t);
  void listen(bool moved);
  void judge_silence();
  bool pending() const;
  bool ends(bool moved);
  bool ends_found();
  Sequence& gathered(std::size_t s);
  bool show();
  std::size_t number_of(const Giver& g) const {
    return static_cast<std::size_t>(&g - givers_.data());
  }
  std::size_t number_of(const Taker& t) const {
    return static_cast<std::size_t>(&t - takers_.data());
  }

  const StreamShape& shape_;
  StreamDut& dut_;
  StreamNets nets_;
  std::vector<Giver> givers_;
  std::vector<Taker> takers_;
  std::unique_ptr<EdgesDrawn> edges_;  // where there are several clocks
  bool has_latency_ = false, is_steady_ = false, is_plain_ = true;

  // Of the case that runs.
  const StreamOrder* order_ = nullptr;
  Random noise_{0};
  std::vector<std::size_t> taken_;  // of each giver, after each clock on which one was taken
  std::vector<std::size_t> due_;    // of each taker, by the last answer
  bool held_ = false;               // by the harness, on this clock
  bool is_shown_ = false;       // the observer has what it wants; the run goes on to its finding
  std::uint64_t quiet_ = 0;     // clocks since something moved or was held; of several, of each
  std::uint64_t moved_at_ = 0;  // the clock after that
  std::uint64_t longest_ = 0, drained_ = 0;
  std::vector<Sequence> gathered_;
  StreamResult result_;
};

}  // namespace cosim
