#include "tb/stream/runner.h"

#include <algorithm>
#include <utility>

namespace cosim {
namespace {

constexpr std::uint64_t gathered_clocks = 2000;

// What a person sees of one interface on a clock, after sample().
InterfaceSeen seen_of(const Giver& g) {
  const bool ready = g.own ? g.moved : g.i.ready.empty() || g.nets.ready.get();
  InterfaceSeen seen{g.offers, ready, g.taken, {}, {}, {}};
  read(g.nets.cells, seen.actual);
  if (g.own && g.offers) {
    const auto words = (*g.given)[g.taken];
    seen.actual.assign(words.begin(), words.end());
  }
  seen.actual.resize(g.i.cells.size());
  seen.expected = seen.actual;
  return seen;
}

InterfaceSeen seen_of(const Taker& t) {
  InterfaceSeen seen{t.valid, t.ready, t.came, {}, {}, {}};
  read(t.nets.cells, seen.actual);
  if (t.own && t.valid) seen.actual = t.words;
  seen.actual.resize(t.i.cells.size());
  seen.expected = seen.actual;
  // What is not valid means nothing.
  if (t.valid && t.came < t.expected->size()) {
    const auto words = (*t.expected)[t.came];
    seen.expected.assign(words.begin(), words.end());
  }
  for (std::size_t c = 0; c < seen.expected.size(); ++c) {
    seen.compared.push_back(t.valid && t.i.is_compared(seen.expected, c));
  }
  return seen;
}

}  // namespace

StreamRunner::StreamRunner(const StreamShape& shape, StreamDut& dut)
    : shape_(shape), dut_(dut), nets_(shape, dut) {
  for (std::size_t s = 0; s < shape.in.size(); ++s) {
    givers_.emplace_back(shape.in[s], nets_.in[s]);
    is_plain_ &= shape.in[s].is_plain();
  }
  for (std::size_t s = 0; s < shape.out.size(); ++s) {
    takers_.emplace_back(shape.out[s], nets_.out[s]);
    is_plain_ &= shape.out[s].is_plain();
    has_latency_ |= shape.out[s].latency >= 0;
    is_steady_ |= shape.out[s].steady;
  }
  is_plain_ &= givers_.size() == 1 && takers_.size() == 1;
  is_plain_ &= shape.clocks.size() == 1 && !shape.clocks.front().falls;
  if (shape.clocks.size() > 1) edges_ = std::make_unique<EdgesDrawn>(shape.clocks.size());
  due_.resize(takers_.size());
}

StreamResult StreamRunner::run(const StreamOrder& order) {
  order_ = &order;
  start();
  reset();
  if (rtl_said) take_said();  // what is said while it is reset does not count
  dut_.begin();
  is_plain_ ? run_clocks<true>() : run_clocks<false>();
  for (const Giver& g : givers_) result_.streams.push_back({g.taken, 0});
  for (const Taker& t : takers_) {
    result_.streams.push_back({t.came, std::min(t.came, t.expected->size())});
  }
  return std::move(result_);
}

void StreamRunner::start() {
  for (std::size_t s = 0; s < givers_.size(); ++s) {
    givers_[s].start(order_->given.given[s], order_->given.in[s]);
  }
  for (std::size_t s = 0; s < takers_.size(); ++s) {
    takers_[s].start(order_->expected[s], order_->given.out[s]);
  }
  noise_ = Random(order_->noise);
  if (edges_) edges_->start(order_->noise);
  held_ = is_shown_ = false;
  quiet_ = moved_at_ = longest_ = drained_ = 0;
  gathered_.clear();
  result_ = StreamResult{};
  taken_.clear();
  if (has_latency_) note_taken();
}

// Before its edge, or after it, each clock that takes one has another level.
template <bool plain>
inline void StreamRunner::set_clocks(bool after) {
  if (plain) return nets_.clocks.front().set(after);
  for (std::size_t c = 0; c < nets_.clocks.size(); ++c) {
    const bool takes = !edges_ || edges_->edges()[c] != 0;
    nets_.clocks[c].set((after && takes) != shape_.clocks[c].falls);
  }
}

// Whose clock does not take its edge stands still.
void StreamRunner::draw_edges() {
  const std::vector<Word>& edges = edges_->step();
  for (Giver& g : givers_) g.stands = edges[g.i.clock] == 0;
  for (Taker& t : takers_) t.stands = edges[t.i.clock] == 0;
}

void StreamRunner::reset() {
  int clocks = 0;
  for (std::size_t p = 0; p < shape_.pins.size(); ++p) {
    const Pin& pin = shape_.pins[p];
    if (pin.kind == Pin::Kind::tied) {
      for (const Net& word : nets_.pins[p]) word.set(&word == nets_.pins[p].data() ? pin.value : 0);
    }
    if (pin.kind == Pin::Kind::reset) clocks = std::max(clocks, pin.clocks);
  }
  for (std::size_t s = 0; s < nets_.in.size(); ++s) {
    if (givers_[s].own) {
      givers_[s].drive_own();
    } else {
      nets_.in[s].valid.set(false);
    }
  }
  for (std::size_t s = 0; s < nets_.out.size(); ++s) {
    if (takers_[s].own) takers_[s].drive_own();
    if (!shape_.out[s].ready.empty()) nets_.out[s].ready.set(false);
    if (!shape_.out[s].credit.empty()) nets_.out[s].credit.set(false);
  }
  for (int c = 0; c <= clocks; ++c) {
    for (std::size_t p = 0; p < shape_.pins.size(); ++p) {
      const Pin& pin = shape_.pins[p];
      if (pin.kind != Pin::Kind::reset) continue;
      nets_.pins[p].front().set(c < pin.clocks ? pin.value : 1 - pin.value);
    }
    // A clock lasts until each of them has had its edge.
    for (bool lasts = c < clocks; lasts; lasts = edges_ && !edges_->all_were()) {
      if (edges_) draw_edges();
      set_clocks<false>(false);
      dut_.eval();
      set_clocks<false>(true);
      dut_.eval();
    }
  }
}

template <bool plain>
inline void StreamRunner::judge(Taker& t) {
  if (!plain && t.i.steady) judge_steady(t);
  if (t.moved) judge_value(t);
  if (!t.valid && t.ready && t.i.latency >= 0 && t.age()) judge_latency(t);
}

inline void StreamRunner::listen(bool moved) {
  if (moved) {
    longest_ = std::max(longest_, quiet_);
    quiet_ = 0;
  }
  if (moved || held_) {
    moved_at_ = result_.clocks + 1;
  } else if (!edges_ || edges_->all_were()) {
    ++quiet_;
  }
  if (quiet_ >= shape_.watchdog && pending()) [[unlikely]]
    judge_silence();
}

inline bool StreamRunner::pending() const {
  bool any = false;
  for (const Taker& t : takers_) any |= t.came < t.expected->size();
  // Of several streams one may wait for what the other does not give.
  return any || (givers_.size() == 1 && givers_.front().left());
}

// After the clock.
inline bool StreamRunner::ends(bool moved) {
  if (result_.finding) [[unlikely]]
    return ends_found();
  if (moved || held_ || pending()) {
    drained_ = 0;
    return false;
  }
  if (!edges_ || edges_->all_were()) ++drained_;
  return drained_ > longest_ + 16;
}

template <bool plain>
[[gnu::always_inline]] inline bool StreamRunner::clock() {
  constexpr std::size_t number = plain ? 1 : std::dynamic_extent;
  const std::span<Giver, number> givers(givers_);
  const std::span<Taker, number> takers(takers_);
  if (!plain && edges_) draw_edges();
  for (Giver& g : givers) g.drive<plain>(noise_);
  for (Taker& t : takers) t.drive<plain>();
  set_clocks<plain>(false);
  eval();
  if (!plain) answer();
  // What the harness itself holds back is no hang.
  bool moved = false;
  held_ = false;
  for (Giver& g : givers) {
    g.sample<plain>();
    moved |= g.moved;
    held_ |= g.held_back();
    if (!plain && g.credits > g.i.credits) found(Kind::credit, true, number_of(g), g.taken);
  }
  if (has_latency_ && moved) note_taken();
  for (Taker& t : takers) {
    t.sample<plain>();
    moved |= t.moved;
    held_ |= t.held_back();
    if (plain || !t.stands) judge<plain>(t);
  }
  listen(moved);
  if (order_->observer != nullptr && !is_shown_) is_shown_ = !show();
  set_clocks<plain>(true);
  eval();
  ++result_.clocks;
  if (moved || (!plain && is_steady_)) {
    for (Giver& g : givers) g.advance();
    for (Taker& t : takers) t.advance<plain>();
  }
  return !ends(moved);
}

// A silence is listened to until it ends.
template <bool plain>
void StreamRunner::run_clocks() {
  while ((result_.clocks < order_->budget || quiet_ > 0) && clock<plain>()) continue;
}

// What is taken by the end of this clock.
void StreamRunner::note_taken() {
  for (const Giver& g : givers_) taken_.push_back(g.taken + (g.moved ? 1 : 0));
  for (Taker& t : takers_) t.note();
}

void StreamRunner::found(Kind kind, bool goes_in, std::size_t stream, std::size_t number,
                         std::size_t cell) {
  if (result_.finding) return;
  const bool stands = kind == Kind::hung || kind == Kind::missing;
  const std::uint64_t clock = stands ? moved_at_ : result_.clocks;
  result_.finding = {kind, goes_in, stream, number, cell, clock};
  for (std::size_t s = 0; s < takers_.size() && stands; ++s) {
    if (takers_[s].waits) result_.finding->waits = s;
  }
}

void StreamRunner::answer() {
  bool any = false;
  for (Giver& g : givers_) any |= g.answer();
  for (Taker& t : takers_) any |= t.answer();
  if (any) eval();
}

inline void StreamRunner::eval() {
  dut_.eval();
  if (rtl_said) [[unlikely]]
    hear();
}

void StreamRunner::hear() {
  const RtlSaid said = take_said();
  if (result_.finding) return;
  found(Kind::said, true, 0, givers_.empty() ? 0 : givers_.front().taken);
  result_.said = said.line_of_report();
}

void StreamRunner::judge_silence() {
  for (std::size_t s = 0; s < givers_.size(); ++s) {
    if (givers_[s].left()) found(Kind::hung, true, s, givers_[s].taken);
  }
  for (std::size_t s = 0; s < takers_.size(); ++s) {
    const Taker& t = takers_[s];
    if (t.came == t.expected->size()) continue;
    found(t.waits ? Kind::hung : Kind::missing, false, s, t.came);
  }
}

void StreamRunner::judge_steady(const Taker& t) {
  if (t.offered && (!t.valid || t.words != t.last)) {
    found(Kind::unsteady, false, number_of(t), t.came);
  }
  if (t.stays && t.came > 0 && t.words != t.last) {
    found(Kind::unsteady, false, number_of(t), t.came - 1);
  }
}

void StreamRunner::judge_value(const Taker& t) {
  if (t.i.credits > 0 && !t.ready) found(Kind::credit, false, number_of(t), t.came);
  if (t.came >= t.expected->size()) {
    found(Kind::extra, false, number_of(t), t.came);
  } else {
    const auto right = (*t.expected)[t.came];
    for (std::size_t c = 0; c < right.size(); ++c) {
      if (t.words[c] == right[c] || !t.i.is_compared(right, c)) continue;
      found(Kind::value, false, number_of(t), t.came, c);
    }
  }
  if (order_->gather) gathered(number_of(t)).push(t.words);
}

void StreamRunner::judge_latency(Taker& t) {
  const std::size_t s = number_of(t);
  if (!t.asked && t.came < t.expected->size()) {
    const std::size_t n = givers_.size();
    order_->due(std::span(taken_).subspan((t.old - 1) * n, n), due_);
    t.due = due_[s];
    t.asked = true;
  }
  if (t.came < t.due) found(Kind::late, false, s, t.came);
}

bool StreamRunner::ends_found() {
  if (order_->gather && result_.finding->kind == Kind::value && quiet_ < shape_.watchdog &&
      result_.clocks < result_.finding->clock + gathered_clocks) {
    return false;
  }
  if (order_->gather && !result_.finding->goes_in) result_.came = gathered(result_.finding->stream);
  return order_->observer == nullptr || is_shown_;
}

Sequence& StreamRunner::gathered(std::size_t s) {
  while (gathered_.size() < takers_.size()) {
    gathered_.emplace_back(shape_.out[gathered_.size()].cells.size());
  }
  return gathered_[s];
}

bool StreamRunner::show() {
  std::vector<InterfaceSeen> in, out;
  for (const Giver& g : givers_) in.push_back(seen_of(g));
  for (const Taker& t : takers_) out.push_back(seen_of(t));
  static const std::vector<Word> none;
  return order_->observer->clock(result_.clocks, edges_ ? edges_->edges() : none, in, out);
}

}  // namespace cosim
