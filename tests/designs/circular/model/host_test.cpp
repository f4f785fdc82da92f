// The device outside of SU 1665343, at work on the model.
#include <gtest/gtest.h>

#include <vector>

#include "tests/designs/circular/records.h"
#include "tests/support/model_adapter.h"
#include "tests/support/recorder.h"

namespace cosim::circular {
namespace {

using Clocks = std::vector<test::Recorder<Design>::Clock>;

Clocks draw(const std::vector<Arc>& arcs) {
  return test::draw(test::model_bench<Design, of_width(4)>(), std::span<const Arc>(arcs));
}

std::size_t steps(const Clocks& clocks, std::size_t job) {
  std::size_t n = 0;
  for (const auto& c : clocks) n += c.job == job && step_of(c.outputs) != Point{};
  return n;
}

std::size_t length(const Clocks& clocks, std::size_t job) {
  std::size_t n = 0;
  for (const auto& c : clocks) n += c.job == job;
  return n;
}

TEST(CircularHost, HasNothingToDoWithoutArcs) {
  HostOf<Design> host(of_width(4), {});
  Inputs<Word> in;
  EXPECT_FALSE(host.next(in, record_of<Outputs<Word>>(Shown{1, 1, 1})));
}

TEST(CircularHost, LoadsAndStartsOnOneClock) {
  const std::vector<Arc> arcs = {{{12, 0}, 144, {}}};
  HostOf<Design> host(of_width(4), arcs);
  Inputs<Word> in;
  ASSERT_TRUE(host.next(
      in, record_of<Outputs<Word>>(Shown{1, 1, 1})));  // what was seen has no meaning here
  EXPECT_EQ(to_words(in), (Words<Inputs<Word>>{0, 1, 10, 0, 11, 0, 1, 0}));
  ASSERT_TRUE(host.next(in, {}));
  EXPECT_EQ(to_words(in), to_words(rest_of<Design>()));
}

// From (8, 9): F = 4.75, X - 1 = 7, X - Y = -1; from (2, 12): F = 144 - 1 - 12.5^2 = -13.25,
// X - 1 = 1, X - Y = -10.
TEST(CircularHost, SendsCodesOfItsWidth) {
  const std::vector<Arc> arcs = {{{8, 9}, 144, {}}, {{2, 12}, 144, 0}};
  HostOf<Design> host(of_width(4), arcs);
  Inputs<Word> in;
  ASSERT_TRUE(host.next(in, {}));
  EXPECT_EQ(to_words(in), (Words<Inputs<Word>>{0, 1, 4, 7, 0b11110, 1, 1, 0}));
  ASSERT_TRUE(host.next(in, {}));
  ASSERT_TRUE(host.next(in, {}));  // not running: on to the next
  EXPECT_EQ(host.job(), 1U);
  EXPECT_EQ(to_words(in), (Words<Inputs<Word>>{0, 1, 64 - 14, 1, 0b10101, 1, 1, 0}));
}

// One clock to load, one a step, one for the sector change, one for the end and one to see it.
TEST(CircularHost, DrawsOneArcAfterTheOther) {
  const Clocks clocks = draw({{{12, 0}, 144, {}}, {{8, 9}, 144, {}}, {{0, 12}, 144, {}}});
  EXPECT_EQ(steps(clocks, 0), 17U);
  EXPECT_EQ(steps(clocks, 1), 8U);
  EXPECT_EQ(steps(clocks, 2), 0U);
  EXPECT_EQ(length(clocks, 0), 1U + 17 + 1 + 2);
  EXPECT_EQ(length(clocks, 1), 1U + 8 + 2);
  EXPECT_EQ(length(clocks, 2), 1U + 2);
  EXPECT_EQ(clocks.size(), 21U + 11 + 3);
  EXPECT_EQ(named<Shown>(clocks.back().outputs).running, 0);
}

TEST(CircularHost, StopsAnArc) {
  for (std::int64_t count = 0; count <= 19; ++count) {
    SCOPED_TRACE(count);
    const Clocks clocks = draw({{{12, 0}, 144, count}, {{8, 9}, 144, {}}});
    EXPECT_EQ(steps(clocks, 0), std::min<std::size_t>(static_cast<std::size_t>(count), 17));
    EXPECT_EQ(steps(clocks, 1), 8U);
  }
}

}  // namespace
}  // namespace cosim::circular
