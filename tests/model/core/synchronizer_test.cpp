// What a synchronizer's first register takes: of each bit the old or the new value, where what it
// samples changes on the step, and never anything else.
#include "model/core/synchronizer.h"

#include <gtest/gtest.h>

#include "tb/sim/hostile.h"
#include "tests/support/error_of.h"
#include "tests/support/struct_design.h"

namespace cosim::sync_test {

using namespace clocked;
using cosim::Word, cosim::to_words;

struct Crossed {
  static constexpr const char* name = "crossed";
  struct In {
    Bit reset;  // at once
    Rises a;    // counts
    Falls b;    // samples the count, and counts its samples
    Sampled<"seen", UInt<3>> seen_new;
    Sampled<"samples", UInt<2>> samples_new;
  };
  struct Out {
    UInt<3> q;
  };
  static constexpr auto reset = active_high<&In::reset>;
  static constexpr bool asynchronous_reset = true;

  UInt<3> count = 0;
  UInt<3> seen = 0;
  UInt<2> samples = 0;

  Out clock(const In& in) {
    const Out out{.q = seen};
    if (in.b) {
      seen = count;
      ++samples;
    }
    if (in.a) ++count;
    return out;
  }
};
using Design = test::StructDesign<Crossed>;
using State = Design::State<Word>;
using Inputs = Design::Inputs<Word>;

Crossed after(const Crossed& model, const Inputs& in) {
  const auto s = record_of<State>(model);
  const auto step = clock_of<Design, Word>({}, s, in);
  return object_of<Crossed>(Synchronizers<Design>({}).taken({}, s, in, step.state));
}
Crossed after(const Crossed& model, const Crossed::In& in) {
  return after(model, record_of<Inputs>(in));
}

// Its input names a register of 2 bits.
template <int W>
struct Unnamed {
  static constexpr const char* name = "unnamed";
  struct In {
    Rises a;
    Rises b;
    Sampled<"held", UInt<W>> taken;
  };
  struct Out {
    Bit q;
  };
  UInt<2> held = 0;
  Out clock(const In&) { return {}; }
};

namespace {

// 3 becomes 4 as it is sampled: every bit changes.
const Crossed three{.count = 3, .seen = 2, .samples = 1};

TEST(Synchronizer, TakesEachBitOldOrNewWhereBothClocksRise) {
  for (int chosen = 0; chosen < 8; ++chosen) {
    const auto s =
        after(three, Crossed::In{.reset = 0, .a = 1, .b = 1, .seen_new = chosen, .samples_new = 0});
    EXPECT_EQ(s.seen, (3 & ~chosen) | (4 & chosen));
    EXPECT_EQ(s.count, 4);
    EXPECT_EQ(s.samples, 2);
  }
  // Of 4 and 5 one bit is another: the other two are the same, whatever is chosen.
  EXPECT_EQ(after(Crossed{.count = 4, .seen = 0, .samples = 0},
                  Crossed::In{.reset = 0, .a = 1, .b = 1, .seen_new = 6, .samples_new = 0})
                .seen,
            4);
}

TEST(Synchronizer, TakesNothingElse) {
  EXPECT_EQ(
      after(three, Crossed::In{.reset = 0, .a = 1, .b = 0, .seen_new = 7, .samples_new = 0}).seen,
      2)
      << "its clock does not rise";
  EXPECT_EQ(
      after(three, Crossed::In{.reset = 0, .a = 0, .b = 1, .seen_new = 7, .samples_new = 0}).seen,
      3)
      << "what it samples does not change";
  EXPECT_EQ(
      after(three, Crossed::In{.reset = 1, .a = 1, .b = 1, .seen_new = 7, .samples_new = 0}).seen,
      0)
      << "it is reset";
  // What a register has from its own clock changes in time.
  EXPECT_EQ(after(three, Crossed::In{.reset = 0, .a = 1, .b = 1, .seen_new = 0, .samples_new = 3})
                .samples,
            2);
}

TEST(Synchronizer, NamesAFieldOfTheStateOfItsWidth) {
  EXPECT_EQ(test::error_of([] { Synchronizers<test::StructDesign<Unnamed<2>>>({}); }), "");
  EXPECT_EQ(test::error_of([] { Synchronizers<test::StructDesign<Unnamed<3>>>({}); }),
            "unnamed: input taken: the state has no held of 3 bits");
}

// As hostile stimulus drives it, a count that crosses as a number is seen as one that it never had,
// and without those inputs it is not.
TEST(Synchronizer, ShowsAHostileStimulusThatManyBitsCross) {
  for (const bool settles : {true, false}) {
    int never = 0;
    HostileStimulus<Design> stimulus({}, {.seed = 1, .index = 0, .clocks = 20000});
    Crossed s;
    for (Inputs words; stimulus.next(words, {});) {
      auto in = object_of<Crossed::In>(words);
      if (settles) in.seen_new = 0;
      const Crossed then = after(s, in);
      // The first step after which it has been sampled: what it was or is.
      if (in.b && then.seen != s.count && then.seen != then.count) ++never;
      s = then;
    }
    EXPECT_EQ(never > 0, !settles);
  }
}

}  // namespace
}  // namespace cosim::sync_test
