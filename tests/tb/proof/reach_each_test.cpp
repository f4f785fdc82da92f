// Many things asked at once: one stimulus for all it reaches, one proof for all that nothing does.
#include "tb/proof/reach_each.h"

#include <gtest/gtest.h>

#include "tb/proof/correspondence.h"
#include "tests/support/solvers.h"

namespace cosim::proof {
namespace {

using nets::Bit;
using nets::no;

TEST(ReachEach, TellsWhatHappensFromWhatNeverDoes) {
  if (!is_installed("yosys-abc")) GTEST_SKIP() << "needs yosys-abc";
  // A counter of three bits that stops at 5, where `go` is given.
  nets::Graph graph;
  const Bit go = graph.input();
  const nets::Bits count{graph.latch(), graph.latch(), graph.latch()};
  const Bit at_5 = graph.and_of(count[2], graph.and_of(count[0], !count[1]));
  Bit carry = graph.and_of(go, !at_5);
  for (const Bit bit : count) {
    graph.next(bit, graph.xor_of(bit, carry));
    carry = graph.and_of(bit, carry);
  }
  const Bit at_6 = graph.and_of(count[2], count[1]);
  const Bit at_3 = graph.and_of(!count[2], graph.and_of(count[0], count[1]));

  std::vector<std::size_t> left;
  const ReachedEach all = reach_each(graph, {at_6, at_3, at_5, no},
                                     std::chrono::steady_clock::now() + std::chrono::hours(1), 1,
                                     [&](std::size_t points) { left.push_back(points); });
  ASSERT_EQ(all.points.size(), 4);
  EXPECT_EQ(all.points[0].ever, Ever::never);
  EXPECT_EQ(all.points[3].ever, Ever::never);
  for (const auto& [point, lit] : {std::pair{1, at_3}, std::pair{2, at_5}}) {
    const auto& reached = all.points[static_cast<std::size_t>(point)];
    ASSERT_EQ(reached.ever, Ever::yes) << point;
    bool is_seen = false;
    for (const auto& row : traced(graph, all.stimuli.at(reached.stimulus), {lit})) {
      is_seen = is_seen || row.front();
    }
    EXPECT_TRUE(is_seen) << point;
  }
  EXPECT_EQ(left.front(), 3);  // the constant is told without a question
  EXPECT_LE(all.stimuli.size(), 2);
}

// A counter of 60 bits, each with a bit beside it that nothing sets: what stays as it is, and what
// only a stimulus longer than any that is looked for reaches.
class ReachEachFar : public testing::Test {
 protected:
  ReachEachFar() {
    Bit carry = graph_.input();
    for (int i = 0; i < 60; ++i) {
      const Bit bit = graph_.latch(), stays = graph_.latch();
      graph_.next(bit, graph_.xor_of(bit, carry));
      graph_.next(stays, graph_.and_of(stays, bit));
      carry = graph_.and_of(bit, carry);
      if (i >= 40) far_.push_back(bit), stay_.push_back(stays);
    }
  }

  nets::Graph graph_;
  nets::Bits far_, stay_;
};

// With time without end: how far the engine comes within some is the machine's.
TEST_F(ReachEachFar, OneStepOfInductionTellsWhatStays) {
  Bit any = no;
  for (const auto& points : {far_, stay_}) {
    for (const Bit point : points) any = graph_.or_of(any, point);
  }
  const auto same =
      corresponding(graph_, any, std::chrono::steady_clock::now() + std::chrono::hours(1));
  ASSERT_TRUE(same);
  for (const Bit point : stay_) EXPECT_EQ((*same)[point.gate()], no);
  for (const Bit point : far_) EXPECT_EQ((*same)[point.gate()], point);
}

TEST_F(ReachEachFar, NothingIsSaidOfWhatIsFarAway) {
  if (!is_installed("yosys-abc")) GTEST_SKIP() << "needs yosys-abc";
  nets::Bits points = far_;
  points.insert(points.end(), stay_.begin(), stay_.end());
  const auto soon = std::chrono::steady_clock::now() + std::chrono::seconds(6);
  const ReachedEach all = reach_each(graph_, points, soon, 1, [](auto) {});
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NE(all.points[i].ever, Ever::yes) << i;
    EXPECT_TRUE(i >= far_.size() || all.points[i].ever == Ever::open) << i;
  }
}

TEST(ReachEach, SaysNothingOfWhatItHasNoTimeFor) {
  nets::Graph graph;
  const Bit any = graph.input();
  const ReachedEach all =
      reach_each(graph, {any}, std::chrono::steady_clock::now(), 1, [](auto) {});
  ASSERT_EQ(all.points.size(), 1);
  EXPECT_EQ(all.points[0].ever, Ever::open);
}

}  // namespace
}  // namespace cosim::proof
