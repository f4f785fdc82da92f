// Every number of the state comes back from its code.
#include "tests/support/reachable.h"

#include "tests/designs/dda/shapes.h"

namespace cosim::dda {
namespace {

void expect_recovered(const Params& p, const State<Word>& s) {
  const auto fields = State<Word>::fields(p);
  const auto numbers = to_words(s), codes = to_words(registers(p, s));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    ASSERT_TRUE(is_state(fields[i], numbers[i])) << fields[i].name << ' ' << numbers[i];
    ASSERT_EQ(value_of(fields[i], codes[i]), numbers[i]) << fields[i].name;
  }
}

TEST(DdaReachable, StatesFitTheRegisters) {
  test::expect_states_fit_the_registers<Design>(expect_recovered);
}

}  // namespace
}  // namespace cosim::dda
