// What each pin of SU 1665343 does in every situation, clause by clause of the RTL's header, on the
// model: width 4, the source's arc of R = 12.
#include <gtest/gtest.h>

#include <string>

#include "tests/designs/circular/records.h"
#include "tests/support/model_machine.h"

namespace cosim::circular {
namespace {

using In = Pins;

constexpr Params kParams = of_width(4);
constexpr Words<Registers<Word>> kCleared = {0, 0, 0b00000011, 0, 0};  // F = +0.75

In rest() { return {}; }
In start(In in = rest()) {
  in.start = 1;
  return in;
}
In load(Word f, Word ct7, Word ct8, In in = rest()) {
  in.load = 1;
  in.f = f;
  in.ct7 = ct7;
  in.ct8 = ct8;
  return in;
}
In load_r12(In in = rest()) { return load(10, 0, 11, in); }  // from (12, 0): F = 10.75
In sector2(In in = rest()) {
  in.sector2 = 1;
  return in;
}
In stop() { return {.stop = 1}; }
/// Every request at once.
In all_requests(In in = rest()) { return sector2(start(load(21, 9, 19, in))); }

class TestedMachine : test::ModelMachine<Design> {
  using Base = test::ModelMachine<Design>;

 public:
  using Base::Base;
  Shown clock(const In& in) {
    return named<Shown>(Base::clock(record_of<circular::Inputs<Word>>(in)));
  }
  Held numbers() const { return named<Held>(state); }
  Held codes() const { return named<Held>(Base::registers()); }
  auto words() const { return to_words(Base::registers()); }
};

class CircularPins : public testing::Test {
 protected:
  void clock(std::initializer_list<In> inputs) {
    for (const In& in : inputs) machine.clock(in);
  }
  Held registers() const { return machine.codes(); }
  auto words() const { return machine.words(); }

  // One clock as a letter: '|' '/' '-' the steps, '.' running without one, ' ' not running.
  static char letter(const Shown& o) {
    if (o.step_x != 0) return o.step_y != 0 ? '/' : '-';
    if (o.step_y != 0) return '|';
    return o.running != 0 ? '.' : ' ';
  }
  // Clocks at rest until the machine is idle.
  std::string finish() {
    std::string steps;
    while (machine.numbers().t4 != 0) steps += letter(machine.clock(rest()));
    return steps;
  }
  // The machine `clocks` clocks after the start of the arc of R = 12.
  static TestedMachine in_the_arc(int clocks) {
    TestedMachine m(kParams);
    m.clock(load_r12());
    if (clocks > 0) m.clock(start());
    for (int i = 1; i < clocks; ++i) m.clock(rest());
    return m;
  }

  TestedMachine machine{kParams};
};

constexpr const char* kR12 = "|||/|/|//./-/-/---.";  // the correction, and the end

TEST_F(CircularPins, DrawsTheArcThatIsLoaded) {
  clock({load_r12(), start()});
  EXPECT_EQ(finish(), kR12);
  EXPECT_EQ(words(), kCleared);
}

TEST_F(CircularPins, LoadAndStartComeAloneOrTogether) {
  clock({start(load_r12())});
  EXPECT_EQ(finish(), kR12);
  clock({load_r12(), rest(), rest(), start()});
  EXPECT_EQ(finish(), kR12);
}

TEST_F(CircularPins, ResetAndStopClearWheneverTheyCome) {
  for (int clocks = 0; clocks <= 22; ++clocks) {
    for (const int pins : {1, 2, 3}) {
      machine = in_the_arc(clocks);
      In in = all_requests();
      in.rst = (pins & 1) != 0;
      in.stop = (pins & 2) != 0;
      machine.clock(in);
      EXPECT_EQ(words(), kCleared) << clocks << " clocks into the arc, pins " << pins;
    }
  }
}

TEST_F(CircularPins, NoStepComesWithStop) {
  for (int clocks = 1; clocks <= 22; ++clocks) {
    machine = in_the_arc(clocks);
    const Word running = machine.numbers().t4;
    const Shown o = machine.clock(stop());
    EXPECT_EQ(o.step_x, 0);
    EXPECT_EQ(o.step_y, 0);
    EXPECT_EQ(o.running, running);
  }
}

// A reset clears behind the clock, like any register: the step of that clock is given.
TEST_F(CircularPins, TheStepComesWithReset) {
  machine = in_the_arc(1);
  EXPECT_EQ(letter(machine.clock({.rst = 1})), '|');
  EXPECT_EQ(words(), kCleared);
}

TEST_F(CircularPins, RequestsWhileAnArcRunsChangeNothing) {
  machine = in_the_arc(1);
  TestedMachine disturbed = machine;
  while (machine.numbers().t4 != 0) {
    const Shown expected = machine.clock(rest());
    EXPECT_EQ(disturbed.clock(all_requests()), expected);
    EXPECT_EQ(disturbed.words(), words());
  }
}

TEST_F(CircularPins, ASecondLoadReplacesTheFirst) {
  clock({load(21, 9, 19), load_r12(), start()});
  EXPECT_EQ(finish(), kR12);
}

TEST_F(CircularPins, Sector2StaysSetUntilAClear) {
  clock({sector2(), rest(), load_r12()});
  EXPECT_EQ(registers().t16, 1);
  clock({stop()});
  EXPECT_EQ(registers().t16, 0);
  clock({load_r12(), start()});
  EXPECT_EQ(finish(), kR12);
}

// The rest of the arc from (8, 9): F = 144 - 7^2 - 9.5^2 = 4.75, X - 1 = 7, X - Y = -1.
TEST_F(CircularPins, StartsInSector2) {
  const In in = load(4, 7, 0b11110);
  const std::string expected = "/-/-/---.";
  clock({sector2(start(in))});
  EXPECT_EQ(finish(), expected);
  clock({sector2(), in, start()});
  EXPECT_EQ(finish(), expected);
  clock({in, start(sector2())});
  EXPECT_EQ(finish(), expected);
}

// The arc from (1, 0) with R^2 = 2: F = 2 - 0.25 - 1 = 0.75.
TEST_F(CircularPins, AStartWithNothingLoadedDrawsFromTheClearedState) {
  clock({start()});
  EXPECT_EQ(finish(), "|.-.");
  EXPECT_EQ(words(), kCleared);
}

// R = 0: X = Y = 0, X - 1 = -1.
TEST_F(CircularPins, AStartBehindTheEndEndsAtOnce) {
  clock({sector2(start(load(-1 + 64, 0b11110, 0)))});
  EXPECT_EQ(finish(), ".");
  EXPECT_EQ(words(), kCleared);
  clock({start(load(5, 0b11110, 3))});  // in sector 1, too
  EXPECT_EQ(finish(), ".");
}

TEST_F(CircularPins, MinusZeroIsStoredAsZero) {
  clock({load(5, 0b11111, 0b11111)});
  EXPECT_EQ(registers().ct7, 0);
  EXPECT_EQ(registers().ct8, 0);
}

// floor(F) in two's complement with .75 behind it: quarters 4 floor(F) + 3, in ones' complement.
TEST_F(CircularPins, FGetsItsFraction) {
  for (Word floor = -32; floor < 32; ++floor) {
    clock({load(floor & 63, 0, 0)});
    const Word quarters = 4 * floor + 3;
    EXPECT_EQ(registers().f, quarters < 0 ? 255 + quarters : quarters) << "floor(F) " << floor;
  }
}

TEST_F(CircularPins, NothingAskedNothingDone) {
  clock({load_r12()});
  const auto before = words();
  for (int i = 0; i < 5; ++i) EXPECT_EQ(letter(machine.clock(rest())), ' ');
  EXPECT_EQ(words(), before);
}

// Counters of 5 bits: 31 numbers from -15 to 15, and round again.
TEST_F(CircularPins, CountersWrapWithTheCarryEndAround) {
  clock({start(load(5, 15, 11)), rest()});  // up from 15
  EXPECT_EQ(registers().ct7, 0b10000);      // -15
  EXPECT_EQ(machine.numbers().ct7, -15);
  clock({stop(), sector2(start(load(5, 3, 0b10000))), rest()});  // a diagonal: down two from -15
  EXPECT_EQ(registers().ct8, 0b01110);                           // 14
  EXPECT_EQ(machine.numbers().ct8, 14);
}

// Channel 3 takes CT7's code with a 1 behind it, every digit inverted: of 10000, which is -15, it
// makes 011110, which is 30.
TEST_F(CircularPins, AStepToACt7BelowZeroAddsTwiceItsSize) {
  clock({start(load(0, 15, 11)), rest()});
  EXPECT_EQ(machine.numbers().ct7, -15);
  EXPECT_EQ(machine.numbers().f, 4 * 30 + 3);
}

// F of 8 bits holds quarters from -127 to 127: -31.25 - 2(-12) ... goes out of range below.
TEST_F(CircularPins, FWrapsWithTheCarryEndAround) {
  // Straight in Y from CT7 = 10 to 11 with F = 0.75 - 23 = -22.25, in range.
  clock({start(load(0, 10, 11)), rest()});
  EXPECT_EQ(machine.numbers().f, -89);
  // Diagonal in sector 1 with F = -31.25 and CT8 = -15 .. is the correction; so CT8 = 0, after it
  // -2: F - 3 = -34.25, that is -137 + 255 quarters.
  clock({stop(), start(load(32, 10, 0)), rest()});
  EXPECT_EQ(machine.numbers().ct8, -2);
  EXPECT_EQ(machine.numbers().f, 4 * -32 + 3 - 12 + 255);
}

// Where sector 1 begins with CT8 below zero the correction comes first; by its parity the code
// counts as -1 or -2.
TEST_F(CircularPins, ANegativeCt8IsCorrectedByItsParity) {
  clock({start(load(5, 9, 0b11100)), rest()});  // -3, as -1: F + 2 * 9, X - 1 = 8, X - Y = 0
  EXPECT_EQ(machine.numbers().f, 4 * (5 + 18) + 3);
  EXPECT_EQ(machine.numbers().ct7, 8);
  EXPECT_EQ(machine.numbers().ct8, 0);
  EXPECT_EQ(machine.numbers().t16, 1);
  clock({stop(), start(load(5, 9, 0b11011)), rest()});  // -4, as -2: F + 2 * 8 + 1
  EXPECT_EQ(machine.numbers().f, 4 * (5 + 17) + 3);
  EXPECT_EQ(machine.numbers().ct7, 7);
  EXPECT_EQ(machine.numbers().ct8, -1);
}

}  // namespace
}  // namespace cosim::circular
