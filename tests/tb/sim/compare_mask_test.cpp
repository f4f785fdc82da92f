// Registers and outputs that mean nothing on some clocks, where they are arrays: every element that
// the shape has is left out with its array, and counted by itself.
#include "tb/sim/compare_mask.h"

#include <gtest/gtest.h>

#include "tb/sim/lockstep.h"
#include "tests/support/model_adapter.h"

namespace cosim::test {
namespace masked {

struct Params {
  int depth = 3;
};

#define MEANT_INPUTS(FIELD)    \
  FIELD(fill, 1, flag, "", "") \
  FIELD(ask, 1, flag, "", "")
#define MEANT_OUTPUTS(FIELD)               \
  FIELD(line, 70, bits.words<3>(), "", "") \
  FIELD(ready, 1, flag, "", "")
#define MEANT_STATE(FIELD)                          \
  FIELD(full, 1, flag, "", "")                      \
  FIELD(store, 5, number.array<4>(p.depth), "", "") \
  FIELD(count, 8, number, "", "")
COSIM_RECORDS(MEANT, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  Step<V> step;
  step.state = s;
  step.state.full = in.fill;
  step.outputs.ready = s.full;
  return step;
}
template <class V>
constexpr auto compared(const Params&, const State<V>& s) {
  return std::array{Stated<V>{"store", is_set(s.full)}};
}
template <class V>
constexpr auto compared(const Params&, const State<V>&, const Inputs<V>& in, const Outputs<V>&) {
  return std::array{Stated<V>{"line", is_set(in.ask)}};
}

struct Design {
  COSIM_DESIGN(masked);
  static constexpr const char* name = "masked";
};

// A model of the same in the RTL's place, with a bit of one cell turned over: of the registers
// where it is below 6, then of the outputs.
std::size_t turned = 0;

class Adapter final : public ModelAdapter<Design, Params{}> {
 public:
  using ModelAdapter::ModelAdapter;
  Outputs outputs() const override { return wrong(ModelAdapter::outputs(), State<Word>::size); }
  State<Word> registers() const override { return wrong(ModelAdapter::registers(), 0); }

 private:
  template <class Record>
  static Record wrong(const Record& record, std::size_t first) {
    auto words = to_words(record);
    if (turned >= first && turned - first < words.size()) words[turned - first] ^= 1;
    return from_words<Record>(words);
  }
};

}  // namespace masked

namespace {

using Counts = std::vector<std::uint64_t>;
constexpr std::size_t kStore = 1, kCount = 5, kLine = 6;

// full; three elements of store; count; two words of line; ready.
TEST(CompareMask, CountsEveryElementThatTheShapeHas) {
  CompareMask<masked::Design> all{masked::Params{}};
  EXPECT_EQ(all.left_out(), Counts(8, 0));
  all.clock({}, {.full = 0}, {.ask = 1}, {});
  all.clock({}, {.full = 0}, {.ask = 0}, {});
  all.clock({}, {.full = 1}, {.ask = 0}, {});
  all.clock({}, {.full = 0}, {.ask = 0}, {});
  EXPECT_EQ(all.left_out(), (Counts{0, 3, 3, 3, 0, 3, 3, 0}));
}

TEST(CompareMask, IsOneSetOfElementsAtATime) {
  CompareMask<masked::Design> all{masked::Params{}};
  all.clock({}, {.full = 1}, {.ask = 0}, {});
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
  lockstep.clock({.fill = is_full});
  return !lockstep.clock({.fill = 0, .ask = asks});
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
