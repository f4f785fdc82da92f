// Registers and outputs that mean nothing on some clocks, where they are arrays: every element that
// the shape has is left out with its array, and counted by itself.
#include "tb/sim/compare_mask.h"

#include <gtest/gtest.h>

#include "tb/sim/lockstep.h"
#include "tests/support/model_adapter.h"
#include "tests/support/struct_design.h"

namespace cosim::test {
namespace masked {

using namespace clocked;
using cosim::Word;

// DEPTH elements, and a line of WIDTH bits.
template <int DEPTH, int WIDTH>
struct Masked {
  static constexpr const char* name = "masked";
  struct In {
    Bit fill;
    Bit ask;
  };
  struct Out {
    UInt<WIDTH> line;
    Bit ready;
  };

  Bit full = 0;
  clocked::Array<UInt<5>, DEPTH> store = 0;
  UInt<8> count = 0;

  Out clock(const In& in) {
    const Out out{.line = 0, .ready = full};
    full = in.fill;
    return out;
  }
  auto compared() const { return stated({{"store", full}}); }
  auto compared(const In& in, const Out&) const { return stated({{"line", in.ask}}); }
};
// The second shape has more elements and words than the first, which is tried.
using First = Masked<3, 70>;
using Design = StructDesign<First, Masked<4, 192>>;

Design::State<Word> state(bool is_full) {
  return clocked::record_of<Design::State<Word>>(First{.full = is_full});
}
Design::Inputs<Word> in(bool fills, bool asks) {
  return clocked::record_of<Design::Inputs<Word>>(First::In{.fill = fills, .ask = asks});
}

// A model of the same in the RTL's place, with a bit of one cell turned over: of the registers
// where it is below 6, then of the outputs.
std::size_t turned = 0;

class Adapter final : public ModelAdapter<Design, Design::Params{}> {
 public:
  using ModelAdapter::ModelAdapter;
  Outputs outputs() const override { return wrong(ModelAdapter::outputs(), Registers::size); }
  Registers registers() const override { return wrong(ModelAdapter::registers(), 0); }

 private:
  template <class Record>
  static Record wrong(const Record& record, std::size_t first) {
    auto cells = to_words(record);
    if (turned >= first && turned - first < cells.size()) cells[turned - first] ^= 1;
    return from_words<Record>(cells);
  }
};

}  // namespace masked

namespace {

using Counts = std::vector<std::uint64_t>;
constexpr std::size_t kStore = 1, kCount = 5, kLine = 6;

// full; three elements of store; count; two words of line; ready.
TEST(CompareMask, CountsEveryElementThatTheShapeHas) {
  CompareMask<masked::Design> all{masked::Design::Params{}};
  EXPECT_EQ(all.left_out(), Counts(8, 0));
  all.clock({}, masked::state(0), masked::in(false, 1), {});
  all.clock({}, masked::state(0), masked::in(false, 0), {});
  all.clock({}, masked::state(1), masked::in(false, 0), {});
  all.clock({}, masked::state(0), masked::in(false, 0), {});
  EXPECT_EQ(all.left_out(), (Counts{0, 3, 3, 3, 0, 3, 3, 0}));
}

TEST(CompareMask, IsOneSetOfElementsAtATime) {
  CompareMask<masked::Design> all{masked::Design::Params{}};
  all.clock({}, masked::state(1), masked::in(false, 0), {});
  for (std::size_t i = 0; i < CompareMask<masked::Design>::size; ++i) {
    EXPECT_EQ(all[i], i < kLine || i > kLine + 2) << i;
  }
  // Of those that the shape has: the fourth element of store and the third word of line are not.
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(all.of_cell(i), i != 5 && i != 6) << i;
}

// Whether lockstep sees the bit of a cell on a clock with these inputs, behind one that fills.
bool seen(std::size_t cell, bool is_full, bool asks) {
  masked::turned = cell;
  Lockstep<masked::Adapter> lockstep(1U);
  lockstep.clock(masked::in(is_full, false));
  return !lockstep.clock(masked::in(false, asks));
}

TEST(CompareMask, LeavesOutNothingElse) {
  for (std::size_t element = 0; element < 3; ++element) {
    EXPECT_TRUE(seen(kStore + element, true, false)) << element;
    EXPECT_FALSE(seen(kStore + element, false, true)) << element;
  }
  for (std::size_t word = 0; word < 2; ++word) {
    EXPECT_TRUE(seen(kLine + word, false, true)) << word;
    EXPECT_FALSE(seen(kLine + word, true, false)) << word;
  }
  for (const std::size_t always : {std::size_t{0}, kCount, kLine + 3}) {
    EXPECT_TRUE(seen(always, false, false)) << always;
  }
}

}  // namespace
}  // namespace cosim::test
