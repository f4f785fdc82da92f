// One interface of a run, clock by clock: drive() before the design settles, sample() after it,
// advance() after the rising edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "tb/stream/dut.h"
#include "tb/stream/sequence.h"
#include "tb/support/random.h"

namespace cosim {

inline std::vector<Word> values_of(const std::vector<Net>& nets) {
  std::vector<Word> values;
  for (const Net& n : nets) values.push_back(n.get());
  return values;
}

/// A stream that goes in, at work.
struct Giver {
  const Interface& i;
  const InterfaceNets& nets;
  const Sequence& given;
  const std::vector<Word>& stalls;
  std::size_t taken = 0;
  Word stalled = 0;  // clocks left
  int credits = 0;
  bool offers = false;  // valid is high
  bool waits = false;   // for done
  bool moved = false;   // on this clock
  std::unique_ptr<OwnGiver> own = i.own.giver ? i.own.giver() : nullptr;

  bool left() const { return taken < given.size(); }
  /// The harness itself makes it wait.
  bool held_back() const { return left() && !offers && stalled != 0; }
  void begin() { stalled = left() ? stalls[taken] : 0; }

  void drive(Random& noise) {
    if (stalled != 0) {
      --stalled;
      offers = false;
    } else if (!offers && left() && !waits && (i.credits == 0 || credits > 0)) {
      offers = true;
      const auto words = given[taken];
      for (std::size_t c = 0; c < nets.cells.size(); ++c) nets.cells[c].set(words[c]);
    }
    if (own) return drive_own();
    nets.valid.set(offers ? 1 : 0);
    if (offers || waits) return;
    for (std::size_t c = 0; c < nets.cells.size(); ++c) {
      nets.cells[c].set(low_bits(static_cast<Word>(noise.next()), i.cells[c].width));
    }
  }
  void drive_own() {
    std::vector<Word> pins(nets.drives.size());
    const std::span<const Word> words = offers ? given[taken] : std::span<const Word>();
    own->drive(offers ? &words : nullptr, pins);
    for (std::size_t p = 0; p < pins.size(); ++p) nets.drives[p].set(pins[p]);
  }
  void sample() {
    if (own) {
      moved = own->took(values_of(nets.reads)) && offers;
      return;
    }
    if (waits && nets.done.get() != 0) waits = false;
    moved = offers && (i.ready.empty() || nets.ready.get() != 0);
    if (i.credits > 0 && nets.credit.get() != 0) ++credits;
    if (!moved) return;
    if (i.credits > 0) --credits;
  }
  /// After the clock.
  void advance() {
    if (!moved) return;
    ++taken;
    offers = false;
    waits = !i.done.empty();
    begin();
  }
};

/// A stream that comes out.
struct Taker {
  const Interface& i;
  const InterfaceNets& nets;
  const Sequence& expected;
  const StreamCase::Side& given;
  std::size_t came = 0;
  Word stalled = 0;
  bool waits = false;          // for valid, before ready
  int credits = 0;             // that the design may still use
  std::deque<Word> returns{};  // credits to give back: clocks each has still to wait
  bool valid = false, ready = false, moved = false, before = false, offered = false;
  bool stays = false;  // a pulse that came before is still high
  std::vector<Word> words{}, last{};
  std::unique_ptr<OwnTaker> own = i.own.taker ? i.own.taker() : nullptr;
  std::uint64_t idle = 0;  // clocks on which it could have taken one

  // What had been taken from the streams that go in when so many clocks were idle; those are left
  // that the latency has not yet passed over.
  struct Taken {
    std::uint64_t idle;
    std::vector<std::size_t> counts;
  };
  std::deque<Taken> recent{};
  std::vector<std::size_t> old{};  // what was taken longer ago than that
  bool asked = true;               // how many are due of it
  std::size_t due = 0;             // that many

  Word stall_of(std::size_t n) const { return n < given.stalls.size() ? given.stalls[n] : 0; }
  bool held_back() const { return stalled != 0 || !returns.empty(); }
  void note(const std::vector<std::size_t>& taken) {
    if (i.latency < 0) return;
    if (!recent.empty() && recent.back().idle == idle) {
      recent.back().counts = taken;
    } else {
      recent.push_back({idle, taken});
    }
  }
  void age() {
    ++idle;
    while (!recent.empty() && idle - recent.front().idle > static_cast<std::uint64_t>(i.latency)) {
      old = std::move(recent.front().counts);
      recent.pop_front();
      asked = false;
    }
  }
  void begin() {
    credits = i.credits;
    next();
  }
  void next() {
    stalled = i.has_ready() ? stall_of(came) : 0;
    waits = came < given.waits.size() && given.waits[came] != 0;
  }

  void drive() {
    if (i.has_ready()) {
      ready = stalled == 0 && !waits;
      if (stalled != 0) --stalled;
      if (own) return drive_own();
      nets.ready.set(ready ? 1 : 0);
    } else if (i.credits > 0) {
      const bool back = !returns.empty() && returns.front() == 0;
      if (back) {
        returns.pop_front();
        ++credits;
      } else if (!returns.empty()) {
        --returns.front();
      }
      nets.credit.set(back ? 1 : 0);
      ready = credits > 0;
    } else {
      ready = true;
    }
  }
  void drive_own() {
    std::vector<Word> pins(nets.drives.size());
    own->drive(ready, pins);
    for (std::size_t p = 0; p < pins.size(); ++p) nets.drives[p].set(pins[p]);
  }
  void sample() {
    if (own) {
      moved = valid = own->came(values_of(nets.reads), words);
      return;
    }
    const bool high = nets.valid.get() != 0;
    stays = i.pulse && high && before;
    valid = high && !stays;
    before = high;
    // Without ready the design gives when it likes.
    moved = valid && (ready || i.ready.empty());
    if (!high) return;
    waits = false;
    words.resize(nets.cells.size());
    for (std::size_t c = 0; c < words.size(); ++c) words[c] = nets.cells[c].get();
  }
  void advance() {
    offered = valid && !moved;
    if (valid && i.steady) last = words;
    if (!moved) return;
    if (i.credits > 0) {
      --credits;
      returns.push_back(stall_of(came));
    }
    ++came;
    next();
  }
};

}  // namespace cosim
