// Every number of the state comes back from its code.
#include "tests/support/reachable.h"

#include "tests/designs/circular/shapes.h"

namespace cosim::circular {
namespace {

void expect_recovered(const Params& p, const State<Word>& s) {
  const auto r = registers(p, s);
  ASSERT_EQ(from_ones_complement(r.f, p.width + 4), s.f);
  ASSERT_EQ(from_ones_complement(r.ct7, p.width + 1), s.ct7);
  ASSERT_EQ(from_ones_complement(r.ct8, p.width + 1), s.ct8);
  ASSERT_NE(r.f, 0);                    // F has no +0
  ASSERT_NE(r.ct7, ones(p.width + 1));  // the counters have no -0
  ASSERT_NE(r.ct8, ones(p.width + 1));
}

TEST(CircularReachable, StatesFitTheRegisters) {
  test::expect_states_fit_the_registers<Design>(expect_recovered);
}

}  // namespace
}  // namespace cosim::circular
