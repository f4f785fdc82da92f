// Each run treats each word of the inputs in its own way: it is held, or changes rarely or often;
// what it changes to is any number, a small one, or an end of the range. So handshakes stall and
// flow, and counters are loaded with what they can count down. After a while, which may be short or
// long, it treats them in another way (biased random simulation, 64 runs at once).
#include "tb/proof/chance.h"

#include <algorithm>
#include <array>
#include <bit>

#include "tb/util/interrupt.h"
#include "tb/util/random.h"

namespace cosim::proof {
namespace {

using Runs = std::uint64_t;  // a bit each

constexpr std::size_t now_and_then = 64;  // clocks

class Stimuli {
 public:
  Stimuli(const nets::Graph& graph, std::uint64_t seed) : random_(Random::for_case(seed, 0)) {
    for (const std::vector<std::size_t>& inputs : graph.words()) {
      words_.push_back({inputs, graph.is_seldom(inputs.front())});
    }
    now_.resize(graph.inputs().size());
    begin_ways();
  }

  const std::vector<Runs>& now() const { return now_; }

  void next() {
    for (const Word& w : words_) {
      Runs all = w.often & (half() | half());
      if (w.rare != 0) all |= w.rare & half() & half() & half() & half() & half();
      if (all != 0) change(w, all);
    }
    if (++clock_ >= first_end_) begin_ways();
  }

 private:
  struct Word {
    std::vector<std::size_t> inputs;  // the lowest bit first
    bool seldom = false;
    Runs rare = 0, often = 0;  // in the others it is held
    Runs low = 0, high = 0;    // where its bits are mostly so
  };
  Runs half() { return random_.next(); }

  // Another way to treat the inputs for those runs whose time is over.
  void begin_ways() {
    constexpr std::uint64_t shortest = 4, lengths = 12;  // powers of two
    Runs over = 0;
    first_end_ = ~std::size_t{0};
    for (unsigned run = 0; run < ends_.size(); ++run) {
      if (ends_[run] <= clock_) {
        over |= Runs{1} << run;
        ends_[run] = clock_ + (std::size_t{1} << (shortest + random_.below(lengths)));
      }
      first_end_ = std::min(first_end_, ends_[run]);
    }
    const auto renew = [over](Runs& old, Runs now) { old = (old & ~over) | (now & over); };
    for (Word& w : words_) {
      const Runs held = w.seldom ? half() | half() : 0;
      renew(w.rare, half() & half() & ~held);
      renew(w.often, half() & ~w.rare & ~held);
      renew(w.low, (half() & half()) | held);
      renew(w.high, half() & half() & ~w.low);
      change(w, over);
      if (w.seldom) now_[w.inputs.front()] &= ~(over & held);
    }
  }

  void change(const Word& w, Runs where) {
    constexpr std::size_t small = 3;  // bits of a small number
    const bool is_word = w.inputs.size() > 1;
    const Runs no_more = is_word ? half() & half() : 0,
               end = is_word ? half() & half() & half() : 0;
    const Runs which = half();
    for (std::size_t bit = 0; bit < w.inputs.size(); ++bit) {
      Runs fresh = half();
      if (w.low != 0) fresh &= ~w.low | (half() & half());
      if (w.high != 0) fresh |= w.high & (half() | half());
      if (bit >= small) fresh &= ~no_more;
      fresh = (fresh & ~end) | (which & end);
      Runs& now = now_[w.inputs[bit]];
      now = (now & ~where) | (fresh & where);
    }
  }

  Random random_;
  std::vector<Word> words_;
  std::vector<Runs> now_;
  std::size_t clock_ = 0, first_end_ = 0;
  std::array<std::size_t, 64> ends_{};
};

}  // namespace

void run_by_chance(const nets::Graph& graph, std::uint64_t seed, std::size_t clocks,
                   const std::function<bool(const nets::Runs&)>& see) {
  const InterruptGuard interrupts;
  Stimuli stimuli(graph, seed);
  nets::Runs runs(graph);
  for (std::size_t clock = 0; clock < clocks; ++clock) {
    if (clock % now_and_then == 0) InterruptGuard::check();
    runs.clock(stimuli.now());
    if (!see(runs)) return;
    stimuli.next();
  }
}

std::vector<std::vector<bool>> by_chance(const nets::Graph& graph, nets::Bit bad,
                                         std::uint64_t seed, std::size_t clocks,
                                         const std::function<bool()>& stop) {
  std::size_t clock = 0;
  Runs met = 0;
  run_by_chance(graph, seed, clocks, [&](const nets::Runs& runs) {
    met = runs.of(bad);
    if (met != 0) return false;
    ++clock;
    return clock % now_and_then != 0 || !stop || !stop();
  });
  if (met == 0) return {};
  const int one = std::countr_zero(met);
  std::vector<std::vector<bool>> rows;
  for (Stimuli again(graph, seed); rows.size() <= clock; again.next()) {
    rows.emplace_back();
    for (const Runs word : again.now()) rows.back().push_back(((word >> one) & 1U) != 0);
  }
  return rows;
}

}  // namespace cosim::proof
