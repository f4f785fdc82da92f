// What no reset reaches is taken over from the RTL, too where the model's state is not its
// registers.
#include <gtest/gtest.h>

#include "tb/dut/dut.h"
#include "tb/sim/lockstep.h"

namespace cosim::test {
namespace kept {

struct Params {};

#define KEPT_INPUTS(FIELD) FIELD(give, 1, flag, "", "")
#define KEPT_OUTPUTS(FIELD)       \
  FIELD(first, 8, number, "", "") \
  FIELD(second, 4, twos_complement, "", "")
#define KEPT_STATE(FIELD)                           \
  FIELD(waits, 1, flag, "", "of the model alone")   \
  FIELD(held, 4, twos_complement.unreset(), "", "") \
  FIELD(store, 8, number.array<2>().unreset(), "", "")
#define KEPT_REGISTERS(FIELD)                          \
  FIELD(store, 8, number.array<2>().unreset(), "", "") \
  FIELD(held, 4, twos_complement.unreset(), "", "")
COSIM_RECORDS(KEPT, Params);
COSIM_RECORD(Registers, KEPT_REGISTERS, Params);

template <class V>
constexpr Registers<V> registers(const Params&, const State<V>& s) {
  return {s.store, low_bits(s.held, 4)};
}
template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>&) {
  return {s, {s.store[1], low_bits(s.held, 4)}};
}

struct Design {
  COSIM_DESIGN(kept);
  static constexpr const char* name = "kept";
};

// RTL that holds 5, 9 and -3, whose code is 13.
class Adapter final : public Dut<Design> {
 public:
  static constexpr Params params{};

  explicit Adapter(int) {}
  void drive(const Inputs&) override {}
  void eval(bool) override {}
  Outputs outputs() const override { return {9, 13}; }
  Registers registers() const override { return {{5, 9}, 13}; }
};

}  // namespace kept

namespace {

TEST(Lockstep, TakesOverByNameWhatNoResetReaches) {
  Lockstep<kept::Adapter> lockstep(1);
  EXPECT_EQ(lockstep.state().store[0], 5);
  EXPECT_EQ(lockstep.state().store[1], 9);
  EXPECT_EQ(lockstep.state().held, -3);
  EXPECT_EQ(lockstep.state().waits, 0);
  EXPECT_TRUE(lockstep.clock({}));
}

}  // namespace
}  // namespace cosim::test
