// What a design may leave out.
#include "model/core/design.h"

#include <gtest/gtest.h>

namespace cosim::plain {
namespace {

struct Params {
  int width;
};

#define PLAIN_INPUTS(FIELD) FIELD(rst, 1, flag, "", "")
#define PLAIN_OUTPUTS(FIELD) FIELD(out, p.width, bits, "", "")
#define PLAIN_STATE(FIELD)                   \
  FIELD(a, p.width, twos_complement, "", "") \
  FIELD(b, p.width, ones_complement, "", "") \
  FIELD(c, p.width, bits.at("deep.c").unreset(), "", "")
COSIM_RECORDS(PLAIN, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>&) {
  return {s, {s.c}};
}

struct Design {
  COSIM_DESIGN(plain);
  static constexpr const char* name = "plain";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
};

// -3 in 5 bits is 29 as two's complement and 28 as ones' complement.
TEST(PlainDesign, HasRegistersThatAreItsStateAsCodes) {
  const State<Word> s{-3, -3, 28};
  const auto r = Design::registers(Params{5}, s);
  EXPECT_EQ(to_words(r), (Words<State<Word>>{29, 28, 28}));
}

TEST(PlainDesign, SaysWhereItsRegistersAreAndWhichNoResetReaches) {
  const auto fields = Design::Registers<Word>::fields(Params{5});
  EXPECT_STREQ(fields[0].net, "a");
  EXPECT_STREQ(fields[2].name, "c");
  EXPECT_STREQ(fields[2].net, "deep.c");
  EXPECT_FALSE(fields[0].unreset);
  EXPECT_TRUE(fields[2].unreset);
}

TEST(PlainDesign, RestsAtZeroAndStartsAtZero) {
  EXPECT_EQ(to_words(rest_of<Design>()), (Words<Inputs<Word>>{0}));
  EXPECT_EQ(to_words(reset_state_of<Design, Word>(Params{5})), (Words<State<Word>>{0, 0, 0}));
  EXPECT_TRUE(parameters_of<Design>(Params{5}).empty());
  EXPECT_STREQ(source_of<Design>(), "");
}

}  // namespace
}  // namespace cosim::plain
