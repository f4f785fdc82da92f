// What no reset reaches is taken over from the RTL, too where the model's state is not its
// registers.
#include <gtest/gtest.h>

#include "tb/dut/dut.h"
#include "tb/sim/lockstep.h"
#include "tests/support/struct_design.h"

namespace cosim::test {
namespace kept {

using namespace clocked;
using cosim::Word;

struct Kept {
  static constexpr const char* name = "kept";
  struct In {
    Bit give;
  };
  struct Out {
    UInt<8> first;
    Int<4> second;
  };

  Auxiliary<Bit> waits = 0;  // of the model alone
  Unreset<Int<4>> held;
  Unreset<clocked::Array<UInt<8>, 2>> store;

  Out clock(const In&) { return {.first = store[1], .second = held}; }
};
using Design = StructDesign<Kept>;

// RTL that holds 5, 9 and -3.
class Adapter final : public Dut<Design> {
 public:
  static constexpr Design::Params params{};

  explicit Adapter(int) {}
  void drive(const Inputs&) override {}
  void eval(bool) override {}
  Outputs outputs() const override { return codes_of<Outputs>(Kept(held_).clock({.give = 0})); }
  Registers registers() const override { return codes_of<Registers>(held_); }

 private:
  Kept held_ = [] {
    Kept k;
    k.held = -3;
    k.store[0] = 5;
    k.store[1] = 9;
    return k;
  }();
};

}  // namespace kept

namespace {

TEST(Lockstep, TakesOverByNameWhatNoResetReaches) {
  Lockstep<kept::Adapter> lockstep(1);
  EXPECT_EQ(to_words(lockstep.state()), (cosim::Words<kept::Design::State<Word>>{0, -3, 5, 9}));
  EXPECT_TRUE(lockstep.clock({}));
}

}  // namespace
}  // namespace cosim::test
