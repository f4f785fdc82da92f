// Every number of the state comes back from its code.
#include "tests/support/reachable.h"

#include "tests/designs/linear/shapes.h"

namespace cosim::linear {
namespace {

void expect_recovered(const Params& p, const State<Word>& s) {
  const auto r = registers(p, s);
  const Word words = r.counter4 + r.trigger30;  // to put out, a formed one included
  const bool extra = r.trigger32 != 0 && r.register5 != 0;
  ASSERT_EQ(((words - extra) << p.gamma()) + r.register5, s.left);
  if (s.formed != 0) {
    ASSERT_EQ(s.running, 1);
    ASSERT_EQ(s.coded, 1);
    ASSERT_GT(s.left, 0);
  }
}

TEST(LinearReachable, StatesFitTheRegisters) {
  test::expect_states_fit_the_registers<Design>(expect_recovered);
}

}  // namespace
}  // namespace cosim::linear
