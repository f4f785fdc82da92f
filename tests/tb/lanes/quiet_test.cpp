// On a quiet clock what is left of the gates gives what all of them give.
#include "tb/lanes/quiet.h"

#include <gtest/gtest.h>

#include <vector>

#include "tb/nets/jobs.h"
#include "tb/nets/runs.h"
#include "tb/util/random.h"
#include "tests/support/shapes.h"

namespace cosim::test {
namespace {

using Runs = std::vector<std::uint64_t>;

Runs at(const Runs& gates, const std::vector<nets::Bit>& bits) {
  Runs all;
  for (const nets::Bit bit : bits) all.push_back(in_runs(gates, bit));
  return all;
}

template <class Design>
void expect_same_where_quiet(const typename Design::Params& p) {
  const nets::Draw draw = nets::draw_of_jobs<Design>(p);
  const auto quiet = lanes::quiet_of(draw);
  ASSERT_TRUE(quiet);
  Random random(3);
  std::uint64_t any = 0, all = ~std::uint64_t{0};
  for (int i = 0; i < 500; ++i) {
    Runs held(draw.clock.held.size()), seen(draw.answer->seen.size());
    for (std::uint64_t& bits : held) bits = random.next();
    for (std::uint64_t& bits : seen) bits = random.next();
    // What the driver holds is often small.
    for (std::size_t b = draw.answer->driver; b < held.size() && i % 2 == 0; ++b) {
      held[b] &= random.next() & random.next();
    }
    const Runs drawn = run(draw.clock.graph, held);
    const std::uint64_t is = ~at(run(quiet->loud.graph, held), quiet->loud.inputs).front();
    any |= is;
    all &= is;
    const Runs inputs = at(drawn, draw.clock.inputs);
    const Runs left = at(run(quiet->draw.graph, held), quiet->draw.inputs);
    for (std::size_t b = 0; b < inputs.size(); ++b) ASSERT_EQ(inputs[b] & is, left[b] & is) << b;
    Runs free = held;
    free.insert(free.end(), seen.begin(), seen.end());
    const Runs answered = run(draw.answer->graph, free), rest = run(quiet->answer.graph, free);
    const Runs after = at(answered, draw.answer->after), then = at(rest, quiet->answer.after);
    for (std::size_t b = 0; b < after.size(); ++b) ASSERT_EQ(after[b] & is, then[b] & is) << b;
    ASSERT_EQ(in_runs(answered, draw.answer->wrong) & is, in_runs(rest, quiet->answer.wrong) & is);
  }
  EXPECT_NE(any, 0U);
  EXPECT_EQ(all, 0U);
  EXPECT_LT(quiet->draw.graph.gates().size(), draw.clock.graph.gates().size());
}

template <class Design>
class QuietOf : public testing::Test {};
TYPED_TEST_SUITE(QuietOf, Designs, DesignNames);

TYPED_TEST(QuietOf, IsTheSame) { for_each_shape<TypeParam>(expect_same_where_quiet<TypeParam>); }

}  // namespace
}  // namespace cosim::test
