// What a synchronizer's first register takes: of each bit the old or the new value, where what it
// samples changes on the step, and never anything else.
#include "model/core/synchronizer.h"

#include <gtest/gtest.h>

#include "tb/sim/hostile.h"
#include "tests/support/error_of.h"

namespace cosim::sync_test {
namespace crossed {

struct Params {};

#define CROSSED_INPUTS(FIELD)                                         \
  FIELD(reset, 1, flag, "", "at once")                                \
  FIELD(a, 1, rises, "", "counts")                                    \
  FIELD(b, 1, falls, "", "samples the count, and counts its samples") \
  FIELD(seen_new, 3, bits.synchronizer("seen"), "", "")               \
  FIELD(samples_new, 2, bits.synchronizer("samples"), "", "")
#define CROSSED_OUTPUTS(FIELD) FIELD(q, 3, bits, "", "")
#define CROSSED_STATE(FIELD)      \
  FIELD(count, 3, number, "", "") \
  FIELD(seen, 3, bits, "", "")    \
  FIELD(samples, 2, number, "", "")
COSIM_RECORDS(CROSSED, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  return {
      {wrap(s.count + in.a, 3), select(is_set(in.b), s.count, s.seen), wrap(s.samples + in.b, 2)},
      {s.seen}};
}

struct Design {
  COSIM_DESIGN(crossed);
  static constexpr const char* name = "crossed";
  static constexpr Inputs<Word> reset_inputs() { return {.reset = 1}; }
  static constexpr bool asynchronous_reset = true;
};

State<Word> after(const State<Word>& s, const Inputs<Word>& in) {
  const auto step = clock_of<Design, Word>({}, s, in);
  return Synchronizers<Design>({}).taken({}, s, in, step.state);
}

}  // namespace crossed
namespace unnamed {

struct Params {
  int width;
};
#define UNNAMED_INPUTS(FIELD) \
  FIELD(a, 1, rises, "", "")  \
  FIELD(b, 1, rises, "", "")  \
  FIELD(taken, p.width, bits.synchronizer("held"), "", "")
#define UNNAMED_OUTPUTS(FIELD) FIELD(q, 1, flag, "", "")
#define UNNAMED_STATE(FIELD) FIELD(held, 2, bits, "", "")
COSIM_RECORDS(UNNAMED, Params);
template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>&) {
  return {s, {}};
}
struct Design {
  COSIM_DESIGN(unnamed);
  static constexpr const char* name = "unnamed";
};

}  // namespace unnamed

namespace {

using crossed::after, crossed::Inputs, crossed::State;

// 3 becomes 4 as it is sampled: every bit changes.
constexpr State<Word> three{.count = 3, .seen = 2, .samples = 1};

TEST(Synchronizer, TakesEachBitOldOrNewWhereBothClocksRise) {
  for (Word chosen = 0; chosen < 8; ++chosen) {
    const auto s = after(three, {.a = 1, .b = 1, .seen_new = chosen});
    EXPECT_EQ(s.seen, (3 & ~chosen) | (4 & chosen));
    EXPECT_EQ(s.count, 4);
    EXPECT_EQ(s.samples, 2);
  }
  // Of 4 and 5 one bit is another: the other two are the same, whatever is chosen.
  EXPECT_EQ(after({.count = 4, .seen = 0, .samples = 0}, {.a = 1, .b = 1, .seen_new = 6}).seen, 4);
}

TEST(Synchronizer, TakesNothingElse) {
  EXPECT_EQ(after(three, {.a = 1, .seen_new = 7}).seen, 2) << "its clock does not rise";
  EXPECT_EQ(after(three, {.b = 1, .seen_new = 7}).seen, 3) << "what it samples does not change";
  EXPECT_EQ(after(three, {.reset = 1, .a = 1, .b = 1, .seen_new = 7}).seen, 0) << "it is reset";
  // What a register has from its own clock changes in time.
  EXPECT_EQ(after(three, {.a = 1, .b = 1, .samples_new = 3}).samples, 2);
}

TEST(Synchronizer, NamesAFieldOfTheStateOfItsWidth) {
  EXPECT_EQ(test::error_of([] { Synchronizers<unnamed::Design>({2}); }), "");
  EXPECT_EQ(test::error_of([] { Synchronizers<unnamed::Design>({3}); }),
            "unnamed: input taken: the state has no held of 3 bits");
}

// As hostile stimulus drives it, a count that crosses as a number is seen as one that it never had,
// and without those inputs it is not.
TEST(Synchronizer, ShowsAHostileStimulusThatManyBitsCross) {
  for (const bool settles : {true, false}) {
    int never = 0;
    HostileStimulus<crossed::Design> stimulus({}, {.seed = 1, .index = 0, .clocks = 20000});
    State<Word> s{};
    for (Inputs<Word> in; stimulus.next(in, {});) {
      if (settles) in.seen_new = 0;
      const State<Word> then = after(s, in);
      // The first step after which it has been sampled: what it was or is.
      if (in.b != 0 && then.seen != s.count && then.seen != then.count) ++never;
      s = then;
    }
    EXPECT_EQ(never > 0, !settles);
  }
}

}  // namespace
}  // namespace cosim::sync_test
