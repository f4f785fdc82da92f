// What each pin of the DDA does in every situation, clause by clause of the RTL's header, on the
// model: width 4, so that an accumulator has 16 and a rate is from -16 to 15.
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "tb/util/random.h"
#include "tests/designs/dda/records.h"

namespace cosim::dda {
namespace {

using In = Pins;
using S = Held;

constexpr Params kParams = of_width(4);

// A number of 5 bits, by division.
Word wrapped(Word v) { return ((v + 16) % 32 + 32) % 32 - 16; }
Word floor_16(Word v) { return v < 0 ? -((15 - v) / 16) : v / 16; }

In rest() { return {}; }
In write(Word address, Word data) { return {.write = 1, .address = address, .data = data}; }
In with_start(In in) {
  in.start = 1;
  return in;
}
In with_stop(In in) {
  in.stop = 1;
  return in;
}

// Every register its own number; free, so that it goes on.
S some() {
  S s;
  s.sequential = s.free = 1;
  s.sx = 3, s.sy = 12, s.rate_x = -11, s.rate_y = 13, s.x = -4, s.y = 6;
  s.left_x = 5, s.left_y = 9, s.two_a = 2, s.b = -1, s.two_c = 7;
  return s;
}
S running(S s) {
  s.running = 1;
  return s;
}
S counted(S s, Word left_x, Word left_y) {
  s.free = 0;
  s.left_x = left_x, s.left_y = left_y;
  return s;
}
// Both rates small enough to be shifted, if they are to be.
S small(S s, Word normalise) {
  s.rate_x = 3, s.rate_y = -2, s.normalise = normalise;
  return s;
}
// One of each situation.
std::vector<S> situations() {
  std::vector<S> all{some(), small(some(), 1), counted(some(), 0, 0)};
  for (const S& s : std::vector<S>(all)) all.push_back(running(s));
  return all;
}

S after(const S& s, const In& in) {
  return named<S>(
      Design::next(kParams, record_of<State<Word>>(s), record_of<Inputs<Word>>(in)).state);
}
Shown during(const S& s, const In& in) {
  return named<Shown>(
      Design::next(kParams, record_of<State<Word>>(s), record_of<Inputs<Word>>(in)).outputs);
}
Word steps(const Shown& o) { return o.x_up | o.x_down | o.y_up | o.y_down; }

// As arrays of words, for EXPECT_EQ to compare and print.
auto words(const S& s) { return to_words(record_of<State<Word>>(s)); }
auto words(const Shown& o) { return to_words(record_of<Outputs<Word>>(o)); }
#define EXPECT_SAME(a, b) EXPECT_EQ(words(a), words(b))

TEST(DdaPins, ResetClearsWheneverItComes) {
  for (const S& s : situations()) {
    In in = with_stop(with_start(write(3, 31)));
    in.rst = 1;
    EXPECT_SAME(after(s, in), S{});
  }
}

TEST(DdaPins, AWriteReachesTheRegisterAtItsAddress) {
  constexpr int kBits[] = {4, 4, 5, 5, 5, 5, 4, 4, 5, 5, 5};  // of addresses 1 and on
  for (Word address = 0; address < 16; ++address) {
    for (Word data = 0; data < 32; ++data) {
      auto expected = words(some());
      if (address == 0) {
        expected[1] = data % 2, expected[2] = data / 2 % 2, expected[3] = data / 4 % 2;
      } else if (address <= 11) {
        const bool is_signed = kBits[address - 1] == 5;
        expected[static_cast<std::size_t>(address) + 3] = is_signed ? wrapped(data) : data % 16;
      }
      EXPECT_EQ(words(after(some(), write(address, data))), expected) << address << ' ' << data;
    }
  }
}

TEST(DdaPins, StartAndStopWhileIdle) {
  EXPECT_SAME(after(some(), rest()), some());
  EXPECT_SAME(after(some(), with_stop(rest())), some());
  EXPECT_SAME(after(some(), with_start(rest())), running(some()));
  EXPECT_SAME(after(some(), with_stop(with_start(rest()))), some());
  S written = some();
  written.x = 9;
  EXPECT_SAME(after(some(), write(5, 9)), written);
  EXPECT_SAME(after(some(), with_stop(write(5, 9))), written);
  EXPECT_SAME(after(some(), with_start(write(5, 9))), running(written));
}

TEST(DdaPins, WritesAndStartsChangeNothingWhileRunning) {
  for (const S& s : situations()) {
    if (s.running == 0) continue;
    for (Word address = 0; address < 16; ++address) {
      EXPECT_SAME(after(s, with_start(write(address, 21))), after(s, rest()));
    }
  }
}

TEST(DdaPins, AStopOrTheEndOnlyStops) {
  for (const S& s : situations()) {
    if (s.running == 0) continue;
    S stopped = s;
    stopped.running = 0;
    EXPECT_SAME(after(s, with_stop(rest())), stopped);
    EXPECT_EQ(steps(during(s, with_stop(rest()))), 0);
  }
  for (const Word normalise : {0, 1}) {
    const S over = small(counted(some(), 0, 0), normalise);
    EXPECT_SAME(after(running(over), rest()), over);
    EXPECT_EQ(steps(during(running(over), rest())), 0);
    EXPECT_EQ(during(running(over), rest()).busy, 1);
  }
}

TEST(DdaPins, RatesAreShiftedUntilOneIsFull) {
  for (Word x = -16; x < 16; ++x) {
    for (Word y = -16; y < 16; ++y) {
      if (std::abs(x) >= 8 || std::abs(y) >= 8) continue;
      S s = running(small(some(), 1));
      s.rate_x = x, s.rate_y = y;
      S shifted = s;
      shifted.rate_x = 2 * x, shifted.rate_y = 2 * y;
      EXPECT_SAME(after(s, rest()), shifted);
      EXPECT_EQ(steps(during(s, rest())), 0);
    }
  }
}

TEST(DdaPins, WhileIdleThereIsNoStep) {
  for (Word sum = 0; sum < 16; ++sum) {
    for (Word rate = -16; rate < 16; ++rate) {
      S s = some();
      s.sx = s.sy = sum, s.rate_x = s.rate_y = rate;
      EXPECT_EQ(words(during(s, rest())), (Words<Outputs<Word>>{0, 0, 0, 0, 0, 32 - 4, 6}));
    }
  }
}

// The rates go into the accumulators, whole sixteens are the steps, and the steps turn the rates:
// by products, where the machine adds.
TEST(DdaPins, AddsInEveryState) {
  Random random = Random::for_case(1, 1);
  const auto number = [&random] { return static_cast<Word>(random.below(32)) - 16; };
  for (int i = 0; i < 200'000; ++i) {
    S s;
    s.running = 1;
    s.sequential = random.one_in_power(1), s.normalise = random.one_in_power(1);
    s.free = random.one_in_power(1);
    s.sx = static_cast<Word>(random.below(16)), s.sy = static_cast<Word>(random.below(16));
    s.rate_x = number(), s.rate_y = number(), s.x = number(), s.y = number();
    s.left_x = static_cast<Word>(random.below(3)), s.left_y = static_cast<Word>(random.below(3));
    s.two_a = number(), s.b = number(), s.two_c = number();
    if (s.free == 0 && s.left_x + s.left_y == 0) continue;
    if (s.normalise != 0 && std::abs(s.rate_x) < 8 && std::abs(s.rate_y) < 8) continue;

    const Word sum_x = s.sx + s.rate_x;
    const Word dx = s.free != 0 || s.left_x != 0 ? floor_16(sum_x) : 0;
    const Word sum_y = s.sy + (s.sequential ? wrapped(s.rate_y + s.two_a * dx) : s.rate_y);
    const Word dy = s.free != 0 || s.left_y != 0 ? floor_16(sum_y) : 0;
    S n = s;
    n.sx = sum_x - 16 * floor_16(sum_x), n.sy = sum_y - 16 * floor_16(sum_y);
    n.rate_x = wrapped(s.rate_x - s.b * dx - s.two_c * dy);
    n.rate_y = wrapped(s.rate_y + s.two_a * dx + s.b * dy);
    n.x = wrapped(s.x + dx), n.y = wrapped(s.y + dy);
    if (s.free == 0) n.left_x -= std::abs(dx), n.left_y -= std::abs(dy);
    ASSERT_EQ(words(after(s, rest())), words(n));
    ASSERT_EQ(words(during(s, rest())), (Words<Outputs<Word>>{1, dx > 0, dx<0, dy> 0, dy < 0,
                                                              (s.x + 32) % 32, (s.y + 32) % 32}));
  }
}

}  // namespace
}  // namespace cosim::dda
