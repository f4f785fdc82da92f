#include "tb/stream/run.h"

#include <algorithm>

#include "tb/stream/seen.h"
#include "tb/stream/sides.h"
#include "tb/support/random.h"

namespace cosim {
namespace {

using Kind = StreamFinding::Kind;

class Runner {
 public:
  Runner(const StreamShape& shape, StreamDut& dut, const StreamOrder& order)
      : shape_(shape), dut_(dut), order_(order), nets_(shape, dut), noise_(order.noise) {
    for (std::size_t s = 0; s < shape.in.size(); ++s) {
      const StreamCase::Side& side = order.given.in[s];
      givers_.push_back({shape.in[s], nets_.in[s], side.given, side.stalls});
      givers_.back().credits = shape.in[s].credits;
    }
    for (std::size_t s = 0; s < shape.out.size(); ++s) {
      takers_.push_back({shape.out[s], nets_.out[s], order.expected[s], order.given.out[s]});
      if (shape.out[s].latency >= 0) has_latency_ = true;
    }
    reset();
    dut_.begin();
    for (Giver& g : givers_) g.begin();
    for (Taker& t : takers_) t.begin();
    if (has_latency_) note_taken();
  }

  StreamResult run() {
    // A silence is listened to until it ends.
    while ((result_.clocks < order_.budget || quiet_ > 0) && clock()) continue;
    return std::move(result_);
  }

 private:
  void edge() {
    nets_.clock.set(0);
    dut_.eval();
    nets_.clock.set(1);
    dut_.eval();
  }

  void reset() {
    int clocks = 0;
    for (std::size_t p = 0; p < shape_.pins.size(); ++p) {
      const Pin& pin = shape_.pins[p];
      if (pin.kind == Pin::Kind::tied) {
        for (const Net& word : nets_.pins[p])
          word.set(&word == nets_.pins[p].data() ? pin.value : 0);
      }
      if (pin.kind == Pin::Kind::reset) clocks = std::max(clocks, pin.clocks);
    }
    for (std::size_t s = 0; s < nets_.in.size(); ++s) {
      if (givers_[s].own) {
        givers_[s].drive_own();
      } else {
        nets_.in[s].valid.set(0);
      }
    }
    for (std::size_t s = 0; s < nets_.out.size(); ++s) {
      if (takers_[s].own) takers_[s].drive_own();
      if (!shape_.out[s].ready.empty()) nets_.out[s].ready.set(0);
      if (!shape_.out[s].credit.empty()) nets_.out[s].credit.set(0);
    }
    for (int c = 0; c <= clocks; ++c) {
      for (std::size_t p = 0; p < shape_.pins.size(); ++p) {
        const Pin& pin = shape_.pins[p];
        if (pin.kind != Pin::Kind::reset) continue;
        nets_.pins[p].front().set(c < pin.clocks ? pin.value : 1 - pin.value);
      }
      if (c < clocks) edge();
    }
  }

  bool clock() {
    for (Giver& g : givers_) g.drive(noise_);
    for (Taker& t : takers_) t.drive();
    nets_.clock.set(0);
    dut_.eval();
    hear();
    bool moved = false, took = false;
    for (Giver& g : givers_) {
      g.sample();
      took |= g.moved;
    }
    for (Taker& t : takers_) {
      t.sample();
      moved |= t.moved;
    }
    moved |= took;
    if (has_latency_ && took) note_taken();
    judge(moved);
    const bool more = order_.observer == nullptr || show();
    nets_.clock.set(1);
    dut_.eval();
    hear();
    ++result_.clocks;
    for (Giver& g : givers_) g.advance();
    for (Taker& t : takers_) t.advance();
    return more && !ends(moved);
  }

  // What is taken by the end of this clock.
  void note_taken() {
    std::vector<std::size_t> taken;
    for (const Giver& g : givers_) taken.push_back(g.taken + (g.moved ? 1 : 0));
    for (Taker& t : takers_) t.note(taken);
  }

  void found(Kind kind, bool goes_in, std::size_t stream, std::size_t number,
             std::size_t cell = 0) {
    if (result_.finding) return;
    const bool stands = kind == Kind::hung || kind == Kind::missing;
    const std::uint64_t clock = stands ? moved_at_ : result_.clocks;
    result_.finding = {kind, goes_in, stream, number, cell, clock};
    for (std::size_t s = 0; s < takers_.size() && stands; ++s) {
      if (takers_[s].waits) result_.finding->waits = s;
    }
  }

  void hear() {
    if (dut_.said() == nullptr || result_.finding) return;
    found(Kind::said, true, 0, givers_.empty() ? 0 : givers_.front().taken);
    result_.said = dut_.said()->line_of_report();
  }

  void judge(bool moved) {
    for (std::size_t s = 0; s < givers_.size(); ++s) {
      const Giver& g = givers_[s];
      if (g.credits > g.i.credits) found(Kind::credit, true, s, g.taken);
    }
    for (std::size_t s = 0; s < takers_.size(); ++s) judge(s, takers_[s]);
    // What the harness itself holds back is no hang.
    bool held = false;
    for (const Giver& g : givers_) held |= g.held_back();
    for (const Taker& t : takers_) held |= t.held_back();
    longest_ = moved ? std::max(longest_, quiet_) : longest_;
    quiet_ = moved ? 0 : quiet_ + (held ? 0 : 1);
    if (moved || held) moved_at_ = result_.clocks + 1;
    held_ = held;
    if (quiet_ < shape_.watchdog || !pending()) return;
    for (std::size_t s = 0; s < givers_.size(); ++s) {
      if (givers_[s].left()) found(Kind::hung, true, s, givers_[s].taken);
    }
    for (std::size_t s = 0; s < takers_.size(); ++s) {
      const Taker& t = takers_[s];
      if (t.came == t.expected.size()) continue;
      found(t.waits ? Kind::hung : Kind::missing, false, s, t.came);
    }
  }

  void judge(std::size_t s, Taker& t) {
    if (t.i.steady && t.offered && (!t.valid || t.words != t.last)) {
      found(Kind::unsteady, false, s, t.came);
    }
    if (t.i.steady && t.stays && t.came > 0 && t.words != t.last) {
      found(Kind::unsteady, false, s, t.came - 1);
    }
    if (t.moved) {
      if (t.i.credits > 0 && !t.ready) found(Kind::credit, false, s, t.came);
      if (t.came >= t.expected.size()) {
        found(Kind::extra, false, s, t.came);
      } else if (!std::equal(t.words.begin(), t.words.end(), t.expected[t.came].begin())) {
        const auto parts =
            std::mismatch(t.words.begin(), t.words.end(), t.expected[t.came].begin());
        found(Kind::value, false, s, t.came,
              static_cast<std::size_t>(parts.first - t.words.begin()));
      }
      ++result_.transactions;
      if (order_.gather) gathered(s).push(t.words);
    }
    if (!t.valid && t.ready && t.i.latency >= 0) {
      t.age();
      if (!t.asked && t.came < t.expected.size()) {
        t.due = order_.due(t.old)[s];
        t.asked = true;
      }
      if (t.came < t.due) found(Kind::late, false, s, t.came);
    }
  }

  bool pending() const {
    bool any = false;
    for (const Taker& t : takers_) any |= t.came < t.expected.size();
    // Of several streams one may wait for what the other does not give.
    return any || (givers_.size() == 1 && givers_.front().left());
  }

  // After the clock.
  bool ends(bool moved) {
    if (result_.finding) {
      if (order_.gather && result_.finding->kind == Kind::value && quiet_ < shape_.watchdog &&
          result_.clocks < result_.finding->clock + gathered_clocks) {
        return false;
      }
      if (order_.gather && !result_.finding->goes_in) {
        result_.came = gathered(result_.finding->stream);
      }
      return order_.observer == nullptr;
    }
    if (moved || held_ || pending()) {
      drained_ = 0;
      return false;
    }
    return ++drained_ > longest_ + 16;
  }

  Sequence& gathered(std::size_t s) {
    while (gathered_.size() < takers_.size()) {
      gathered_.emplace_back(shape_.out[gathered_.size()].cells.size());
    }
    return gathered_[s];
  }

  bool show() {
    std::vector<InterfaceSeen> in, out;
    for (const Giver& g : givers_) in.push_back(seen_of(g));
    for (const Taker& t : takers_) out.push_back(seen_of(t));
    return order_.observer->clock(result_.clocks, in, out);
  }

  static constexpr std::uint64_t gathered_clocks = 2000;

  const StreamShape& shape_;
  StreamDut& dut_;
  const StreamOrder& order_;
  StreamNets nets_;
  Random noise_;
  std::vector<Giver> givers_;
  std::vector<Taker> takers_;
  bool has_latency_ = false;
  bool held_ = false;           // by the harness, on this clock
  std::uint64_t quiet_ = 0;     // clocks since something moved or was held
  std::uint64_t moved_at_ = 0;  // the clock after that
  std::uint64_t longest_ = 0, drained_ = 0;
  std::vector<Sequence> gathered_;
  StreamResult result_;
};

}  // namespace

StreamResult run_stream(const StreamShape& shape, StreamDut& dut, const StreamOrder& order) {
  return Runner(shape, dut, order).run();
}

}  // namespace cosim
