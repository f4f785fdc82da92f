// The cycle model of SU 1631518 against the printed tables and the oracle.
#include <gtest/gtest.h>

#include "tests/designs/linear/counts.h"
#include "tests/designs/linear/printed.h"
#include "tests/designs/linear/shapes.h"
#include "tests/support/model_adapter.h"
#include "tests/support/reachable.h"

namespace cosim::linear {
namespace {

template <int m, int n>
const LinearBench& model() {
  return test::model_bench<Design, of(m, n)>();
}

TEST(LinearModel, DrawsTable1) {
  printed::expect_table1(model<5, 2>());
  printed::expect_table1(model<6, 3>());
  printed::expect_table1(model<24, 21>());
}

TEST(LinearModel, DrawsTable2) {
  printed::expect_table2(model<5, 2>());
  printed::expect_table2(model<16, 13>());
}

// With its row 000, which a machine never shows.
TEST(LinearModel, HasTheWordsOfTable2) {
  for (std::size_t remainder = 0; remainder < 8; ++remainder) {
    EXPECT_EQ(static_cast<Word>(Linear<5, 2>::first(remainder)), printed::kTable2[remainder]);
  }
}

TEST(LinearModel, DrawsTable3) { printed::expect_table3(model<5, 2>()); }

TEST(LinearModelAgainstOracle, EveryLineM2N1) { counted::expect_every_line(model<2, 1>()); }
TEST(LinearModelAgainstOracle, EveryLineM5N2) { counted::expect_every_line(model<5, 2>()); }
TEST(LinearModelAgainstOracle, EveryLineM6N3) { counted::expect_every_line(model<6, 3>()); }
TEST(LinearModelAgainstOracle, EveryLineM7N1) { counted::expect_every_line(model<7, 1>()); }
TEST(LinearModelAgainstOracle, EveryLineM8N5) { counted::expect_every_line(model<8, 5>()); }

TEST(LinearModelAgainstOracle, RandomLines) {
  counted::expect_random_lines(model<16, 12>(), 1, 5000);
  counted::expect_random_lines(model<16, 13>(), 2, 5000);
  counted::expect_random_lines(model<24, 21>(), 3, 5000);
  counted::expect_random_lines(model<32, 26>(), 4, 5000);
  counted::expect_random_lines(model<32, 31>(), 5, 5000);
}

// The registers are the state.
void expect_recovered(const Params& p, const State<Word>& s) {
  ASSERT_EQ(named<Held>(Design::registers(p, s)), named<Held>(s));
}

TEST(LinearReachable, StatesFitTheRegisters) {
  test::expect_states_fit_the_registers<Design>(expect_recovered);
}

}  // namespace
}  // namespace cosim::linear
