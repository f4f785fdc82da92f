// What each pin of SU 1631518 does in every situation, clause by clause of the RTL's header, on the
// model: m = 5, n = 2, the source's example.
#include <gtest/gtest.h>

#include "tb/sim/hostile.h"
#include "tests/designs/linear/records.h"
#include "tests/support/model_machine.h"

namespace cosim::linear {
namespace {

using In = Pins;

constexpr Params kParams = of(5, 2);
constexpr Word kBp = 27, kUk = 0b01010;

In rest() { return {}; }
In write_bp(Word bp) { return {.write_bp = 1, .data = bp}; }
In write_uk(Word uk) { return {.write_uk = 1, .data = uk}; }
In start() { return {.start = 1}; }
In initial_set() { return {.initial_set_n = 0}; }
/// Every request at once.
In all_requests(In in) {
  in.write_bp = in.write_uk = in.start = 1;
  in.data = 0b10101;
  return in;
}

class TestedMachine : test::ModelMachine<Design> {
  using Base = test::ModelMachine<Design>;

 public:
  using Base::Base;
  Shown clock(const In& in) { return named<Shown>(Base::clock(in)); }
  Held registers() const { return named<Held>(Base::registers()); }
  auto words() const { return to_words(Base::registers()); }
};

class LinearPins : public testing::Test {
 protected:
  void clock(std::initializer_list<In> inputs) {
    for (const In& in : inputs) machine.clock(in);
  }
  Held registers() const { return machine.registers(); }
  auto words() const { return machine.words(); }

  struct Drawn {
    std::vector<Word> major, minor;
    int busy = 0;    // clocks
    int strobe = 0;  // clocks
  };
  // Clocks at rest until the machine is idle.
  Drawn finish() {
    Drawn drawn;
    while (machine.registers().trigger31 != 0) {
      const Shown o = machine.clock(rest());
      drawn.busy += o.busy != 0;
      if (o.strobe == 0) continue;
      ++drawn.strobe;
      drawn.major.push_back(o.major);
      drawn.minor.push_back(o.minor);
    }
    return drawn;
  }
  // The machine `clocks` clocks after the start of the example's line; 0: before it, 6: it is over.
  static TestedMachine in_the_line(int clocks) {
    TestedMachine m(kParams);
    m.clock(write_bp(kBp));
    m.clock(write_uk(kUk));
    if (clocks > 0) m.clock(start());
    for (int i = 1; i < clocks; ++i) m.clock(rest());
    return m;
  }

  TestedMachine machine{kParams};
};

TEST_F(LinearPins, ResetClearsEverythingWheneverItComes) {
  for (int clocks = 0; clocks <= 8; ++clocks) {
    for (const Word set : {0, 1}) {
      machine = in_the_line(clocks);
      In in = all_requests(rest());
      in.reset = 1;
      in.initial_set_n = set;
      machine.clock(in);
      EXPECT_EQ(words(), (cosim::Words<Registers<Word>>{})) << clocks << " clocks into the line";
    }
  }
}

TEST_F(LinearPins, InitialSetForgetsTheLineAndKeepsTheCode) {
  for (int clocks = 0; clocks <= 8; ++clocks) {
    machine = in_the_line(clocks);
    machine.clock(all_requests(initial_set()));
    EXPECT_EQ(registers(), (Held{.register3 = 0b10, .register9 = 0b0100010}))
        << clocks << " clocks into the line";
  }
}

TEST_F(LinearPins, NoLineIsLeftAfterInitialSet) {
  clock({write_bp(kBp), initial_set(), write_uk(kUk)});
  EXPECT_EQ(registers().counter4, 0);
  clock({start()});
  EXPECT_EQ(finish().strobe, 0);

  clock({write_bp(kBp), write_uk(kUk), initial_set(), start()});
  EXPECT_EQ(registers().trigger31, 0);  // the code has to be written again
}

TEST_F(LinearPins, DrawsTheLineThatIsWritten) {
  clock({write_bp(kBp), write_uk(kUk), start()});
  const Drawn drawn = finish();
  EXPECT_EQ(drawn.major, (std::vector<Word>{0b11111111, 0b11111111, 0b11111111, 0b11100000}));
  EXPECT_EQ(drawn.minor, (std::vector<Word>{0b01000101, 0b01000100, 0b01000101, 0b01000000}));
}

// Busy from the clock after the start to the last strobe; strobes from the second clock after it,
// ceil(BP / 8) of them, one a clock.
TEST_F(LinearPins, StrobeFollowsTheStartByTwoClocks) {
  for (Word bp = 0; bp < 32; ++bp) {
    clock({write_bp(bp), write_uk(kUk)});
    const Word words = (bp + 7) / 8;
    for (Word t = 0; t <= words + 4; ++t) {
      const Shown o = machine.clock(t == 0 ? start() : rest());
      EXPECT_EQ(o.strobe, t >= 2 && t < 2 + words) << "BP = " << bp << " clock " << t;
      EXPECT_EQ(o.busy, t >= 1 && t < 2 + words) << "BP = " << bp << " clock " << t;
    }
  }
}

TEST_F(LinearPins, AnEmptyLineIsBusyForOneClock) {
  clock({write_bp(0), write_uk(kUk), start()});
  const Drawn drawn = finish();
  EXPECT_EQ(drawn.busy, 1);
  EXPECT_EQ(drawn.strobe, 0);
}

TEST_F(LinearPins, RequestsWhileBusyChangeNothing) {
  for (Word bp = 0; bp < 32; ++bp) {
    TestedMachine disturbed(kParams);
    for (const In& in : {write_bp(bp), write_uk(kUk), start()}) {
      machine.clock(in);
      disturbed.clock(in);
    }
    while (machine.registers().trigger31 != 0) {
      const Shown expected = machine.clock(rest());
      EXPECT_EQ(disturbed.clock(all_requests(rest())), expected) << "BP = " << bp;
      EXPECT_EQ(disturbed.words(), words()) << "BP = " << bp;
    }
  }
}

TEST_F(LinearPins, ACodeWithoutANewLineDrawsNothing) {
  clock({write_bp(kBp), write_uk(kUk), start()});
  EXPECT_EQ(finish().strobe, 4);
  clock({write_uk(kUk), start()});
  const Drawn again = finish();
  EXPECT_EQ(again.busy, 1);
  EXPECT_EQ(again.strobe, 0);
}

TEST_F(LinearPins, AStartWithoutACodeDoesNothing) {
  const auto expect_idle = [&] {
    const auto before = words();
    machine.clock(start());
    EXPECT_EQ(words(), before);
    EXPECT_EQ(registers().trigger31, 0);
  };
  expect_idle();  // nothing was ever written
  clock({write_bp(kBp)});
  expect_idle();  // BP alone
  clock({write_uk(kUk), start()});
  finish();
  expect_idle();  // after the line's end
}

TEST_F(LinearPins, ASecondBpReplacesTheFirstAndTheCodeIsDue) {
  clock({write_bp(31), write_bp(kBp), write_uk(kUk), start()});
  EXPECT_EQ(finish().strobe, 4);
  clock({write_bp(31), write_uk(kUk), write_bp(kBp), start()});
  EXPECT_EQ(registers().trigger31, 0);
  EXPECT_EQ(registers().trigger32, 0);
  clock({write_uk(kUk), start()});
  EXPECT_EQ(finish().major.back(), 0b11100000);
}

TEST_F(LinearPins, WriteBpWinsOverWriteUkAndStart) {
  clock({write_bp(kBp), write_uk(kUk), all_requests(rest())});
  EXPECT_EQ(registers().counter4, 2);  // 21 = 2 * 8 + 5, no code counted
  EXPECT_EQ(registers().register5, 5);
  EXPECT_EQ(registers().register3, 0b10);  // the code that stood there
  EXPECT_EQ(registers().register9, 0b0100010);
  EXPECT_EQ(registers().trigger31, 0);
  EXPECT_EQ(registers().trigger32, 0);
}

TEST_F(LinearPins, WriteUkWinsOverStart) {
  clock({write_bp(kBp), write_uk(0)});
  clock({{.write_uk = 1, .start = 1, .data = kUk}});
  EXPECT_EQ(registers().trigger31, 0);
  EXPECT_EQ(registers().trigger32, 1);
  EXPECT_EQ(registers().register3, 0b10);
}

TEST_F(LinearPins, ACodeWrittenTwiceCountsTheRemainderOnce) {
  clock({write_bp(kBp), write_uk(0b11111)});
  EXPECT_EQ(registers().counter4, 4);
  clock({write_uk(kUk)});
  EXPECT_EQ(registers().counter4, 4);
  clock({start()});
  EXPECT_EQ(finish().minor, (std::vector<Word>{0b01000101, 0b01000100, 0b01000101, 0b01000000}));
}

TEST_F(LinearPins, WithoutARemainderNoWordIsAdded) {
  clock({write_bp(24)});
  EXPECT_EQ(registers().counter4, 3);
  clock({write_uk(kUk)});
  EXPECT_EQ(registers().counter4, 3);
  clock({start()});
  EXPECT_EQ(finish().major, (std::vector<Word>(3, 0b11111111)));
}

// 31 = 3 * 8 + 7: counter 4 has to hold 2^n.
TEST_F(LinearPins, TheLongestLineHasTwoToTheNWords) {
  clock({write_bp(31), write_uk(0b11111)});
  EXPECT_EQ(registers().counter4, 4);
  clock({start()});
  const Drawn drawn = finish();
  EXPECT_EQ(drawn.strobe, 4);
  EXPECT_EQ(drawn.minor.back(), 0b11111110);
}

TEST_F(LinearPins, NothingAskedNothingDone) {
  for (const In& in : {rest(), write_bp(kBp), write_uk(kUk)}) {
    machine.clock(in);
    const auto before = words();
    for (int i = 0; i < 5; ++i) machine.clock(rest());
    EXPECT_EQ(words(), before);
  }
}

// Data alone is no request.
TEST_F(LinearPins, DataWithoutAWriteIsNotTaken) {
  clock({{.data = 31}});
  EXPECT_EQ(words(), (cosim::Words<Registers<Word>>{}));
}

TEST_F(LinearPins, WordsAreZeroWithoutAStrobe) {
  HostileStimulus<Design> hostile(kParams, {5, 0, 100'000});
  test::ModelMachine<Design> model(kParams);
  Inputs<Word> in;
  int strobes = 0;
  for (Outputs<Word> out; hostile.next(in, out);) {
    out = model.clock(in);
    const auto o = named<Shown>(out);
    strobes += o.strobe != 0;
    if (o.strobe == 0) {
      ASSERT_EQ(o.major, 0);
      ASSERT_EQ(o.minor, 0);
    } else {
      ASSERT_EQ(o.busy, 1);
      ASSERT_NE(o.major, 0);
    }
  }
  EXPECT_GT(strobes, 100);
}

}  // namespace
}  // namespace cosim::linear
