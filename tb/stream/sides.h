// One interface, clock by clock: drive() before the design settles, sample() after it, advance()
// after the rising edge. It is kept from case to case, and start() begins one: a clock looks
// nothing up and allocates nothing. The three are compiled twice: `plain` is for a design of one
// stream in and one out that are is_plain(), which leaves half of what they ask out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tb/stream/dut.h"
#include "tb/stream/sequence.h"
#include "tb/stream/shape.h"
#include "tb/util/random.h"

namespace cosim {

/// Reads them into `values`, which it gives.
inline std::span<const Word> read(const std::vector<Net>& nets, std::vector<Word>& values) {
  values.resize(nets.size());
  for (std::size_t n = 0; n < nets.size(); ++n) values[n] = nets[n].get();
  return values;
}

/// A stream that goes in, at work.
struct Giver {
  Giver(const Interface& interface, const InterfaceNets& its) : i(interface), nets(its) {}

  const Interface& i;
  const bool has_ready = !i.ready.empty(), has_done = !i.done.empty();
  const InterfaceNets& nets;
  const Sequence* given = nullptr;
  const std::vector<Word>* stalls = nullptr;
  std::size_t taken = 0;
  Word stalled = 0;  // clocks left
  int credits = 0;
  bool offers = false;  // valid is high
  bool waits = false;   // for done
  bool moved = false;   // on this clock
  bool stands = false;  // this clock is none of its own
  std::unique_ptr<OwnGiver> own{};
  std::vector<Word> pins{}, driven{};  // of its own driver

  /// A new case, which stays as long as it runs.
  void start(const Sequence& all, const StreamCase::Side& side) {
    given = &all;
    stalls = &side.stalls;
    taken = 0;
    credits = i.credits;
    offers = waits = moved = stands = false;
    own = i.own.giver ? i.own.giver() : nullptr;
    next();
  }
  bool left() const { return taken < given->size(); }
  /// The harness itself makes it wait.
  bool held_back() const { return left() && !offers && stalled != 0; }
  void next() { stalled = left() ? (*stalls)[taken] : 0; }

  template <bool plain>
  void drive(Random& noise) {
    if (!plain && stands) return;
    if (stalled != 0) {
      --stalled;
      offers = false;
    } else if (!offers && left() && (plain || (!waits && (i.credits == 0 || credits > 0)))) {
      offers = true;
      const auto words = (*given)[taken];
      for (std::size_t c = 0; c < nets.cells.size(); ++c) nets.cells[c].set(words[c]);
    }
    if (!plain && own) return drive_own();
    nets.valid.set(offers);
    if (offers || (!plain && waits)) return;
    for (const Net& cell : nets.cells) {
      cell.set(low_bits(static_cast<Word>(noise.next()), cell.width));
    }
  }
  void drive_own() {
    pins.assign(nets.drives.size(), 0);
    const std::span<const Word> words = offers ? (*given)[taken] : std::span<const Word>();
    own->drive(offers ? &words : nullptr, pins);
    for (std::size_t p = 0; p < pins.size(); ++p) nets.drives[p].set(pins[p]);
  }
  /// What its own driver drives once the design has settled; false: nothing else.
  bool answer() {
    if (!own || stands) return false;
    driven.resize(nets.drives.size());
    if (!own->answer(read(nets.reads, pins), driven)) return false;
    for (std::size_t p = 0; p < driven.size(); ++p) nets.drives[p].set(driven[p]);
    return true;
  }
  template <bool plain>
  void sample() {
    if (!plain && stands) {
      moved = false;
      return;
    }
    if (!plain && own) {
      moved = own->took(read(nets.reads, pins)) && offers;
      return;
    }
    moved = offers && (!has_ready || nets.ready.get());
    if (plain) return;
    if (waits && nets.done.get()) waits = false;
    if (i.credits > 0) credits += (nets.credit.get() ? 1 : 0) - (moved ? 1 : 0);
  }
  /// After the clock.
  void advance() {
    if (!moved) return;
    ++taken;
    offers = false;
    waits = has_done;
    next();
  }
};

/// A stream that comes out.
struct Taker {
  Taker(const Interface& interface, const InterfaceNets& its) : i(interface), nets(its) {}

  const Interface& i;
  const bool has_ready = i.has_ready(), has_port = !i.ready.empty();
  const InterfaceNets& nets;
  const Sequence* expected = nullptr;
  const StreamCase::Side* given = nullptr;
  std::size_t came = 0;
  Word stalled = 0;
  bool waits = false;           // for valid, before ready
  int credits = 0;              // that the design may still use
  std::vector<Word> returns{};  // of each that came: clocks until its credit goes back
  std::size_t returned = 0;     // so many of them have gone
  bool valid = false, ready = false, moved = false, before = false, offered = false;
  bool stays = false;   // a pulse that came before is still high
  bool stands = false;  // this clock is none of its own
  std::vector<Word> words{}, last{};
  std::unique_ptr<OwnTaker> own{};
  std::vector<Word> pins{}, driven{};  // of its own driver

  // Of the latency: the run keeps a list of what had been taken from the streams that go in.
  std::uint64_t idle = 0;              // clocks on which it could have taken one
  std::vector<std::uint64_t> noted{};  // of each entry of that list: `idle` then
  std::size_t old = 0;                 // so many entries are older than the latency
  bool asked = true;                   // how many are due of the last of those
  std::size_t due = 0;                 // that many

  /// A new case, which stays as long as it runs.
  void start(const Sequence& all, const StreamCase::Side& side) {
    expected = &all;
    given = &side;
    came = returned = old = due = 0;
    credits = i.credits;
    returns.clear();
    noted.clear();
    valid = ready = moved = before = offered = stays = stands = false;
    // A run that was cut short may have left some behind.
    words.clear();
    last.clear();
    idle = 0;
    asked = true;
    own = i.own.taker ? i.own.taker() : nullptr;
    next();
  }
  Word stall_of(std::size_t n) const { return n < given->stalls.size() ? given->stalls[n] : 0; }
  bool held_back() const { return stalled != 0 || returned < returns.size(); }
  /// The list has one more entry.
  void note() {
    if (i.latency >= 0) noted.push_back(idle);
  }
  /// One more clock on which it could have taken one: false where nothing is due by it for sure.
  bool age() {
    ++idle;
    while (old < noted.size() && idle - noted[old] > static_cast<std::uint64_t>(i.latency)) {
      ++old;
      asked = false;
    }
    return !asked || came < due;
  }
  void next() {
    stalled = has_ready ? stall_of(came) : 0;
    waits = came < given->waits.size() && given->waits[came] != 0;
  }

  template <bool plain>
  void drive() {
    if (!plain && stands) return;
    if (has_ready) {
      ready = stalled == 0 && !waits;
      if (stalled != 0) --stalled;
      if (!plain && own) return drive_own();
      nets.ready.set(ready);
    } else if (!plain && i.credits > 0) {
      const bool back = returned < returns.size() && returns[returned] == 0;
      if (back) {
        ++returned;
        ++credits;
      } else if (returned < returns.size()) {
        --returns[returned];
      }
      nets.credit.set(back);
      ready = credits > 0;
    } else {
      ready = true;
    }
  }
  void drive_own() {
    pins.assign(nets.drives.size(), 0);
    own->drive(ready, pins);
    for (std::size_t p = 0; p < pins.size(); ++p) nets.drives[p].set(pins[p]);
  }
  /// What its own driver drives once the design has settled; false: nothing else.
  bool answer() {
    if (!own || stands) return false;
    driven.resize(nets.drives.size());
    if (!own->answer(read(nets.reads, pins), driven)) return false;
    for (std::size_t p = 0; p < driven.size(); ++p) nets.drives[p].set(driven[p]);
    return true;
  }
  template <bool plain>
  void sample() {
    if (!plain && stands) {
      moved = false;
      return;
    }
    if (!plain && own) {
      moved = valid = own->came(read(nets.reads, pins), words);
      return;
    }
    const bool high = nets.valid.get();
    stays = !plain && i.pulse && high && before;
    valid = high && !stays;
    before = high;
    // Without ready the design gives when it likes.
    moved = valid && (ready || !has_port);
    if (!high) return;
    waits = false;
    if (moved || (!plain && i.steady)) read(nets.cells, words);
  }
  template <bool plain>
  void advance() {
    if (!plain && stands) return;
    offered = valid && !moved;
    if (!plain && valid && i.steady) last = words;
    if (!moved) return;
    if (!plain && i.credits > 0) {
      --credits;
      returns.push_back(stall_of(came));
    }
    ++came;
    next();
  }
};

}  // namespace cosim
