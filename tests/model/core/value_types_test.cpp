// The models on value types other than machine integers: the same numbers on every clock.

#include <gtest/gtest.h>

#include <concepts>
#include <vector>

#include "tb/sim/hostile.h"
#include "tests/support/lanes.h"
#include "tests/support/model_machine.h"
#include "tests/support/shapes.h"
#include "tests/support/strict.h"

namespace cosim::test {
namespace {

// What would make the strict type worthless.
template <class V>
concept branches = requires(Condition<V> c) {
  static_cast<bool>(c);
};
template <class V>
concept has_short_circuit = requires(Condition<V> c) {
  c&& c;
};
template <class V>
concept divides = requires(V v) {
  v / v;
};
template <class V>
concept indexes = requires(V v, const int* table) {
  table[v];
};
static_assert(branches<Word> && has_short_circuit<Word> && divides<Word> && indexes<Word>);
static_assert(!branches<Strict> && !has_short_circuit<Strict> && !divides<Strict> &&
              !indexes<Strict>);
static_assert(!std::convertible_to<Word, Strict> && !std::convertible_to<Strict, Word>);

// A record of one value type from a record of another, member by member.
template <class To, class From, class Convert>
To converted(const From& from, Convert convert) {
  To to;
  for_each_member<From>(
      [&](auto member, std::size_t i) { to.*(To::members()[i]) = convert(from.*member); });
  return to;
}

constexpr std::uint64_t kClocks = 20'000;

template <class Design>
HostileStimulus<Design> stimulus(const typename Design::Params& p, std::uint64_t index) {
  return {p, HostileCase{7, index, kClocks}};
}

template <class Design>
void expect_strict_steps(const typename Design::Params& p) {
  auto hostile = stimulus<Design>(p, 0);
  ModelMachine<Design> machine(p);
  auto state = reset_state_of<Design, Strict>(p);
  const auto words = [](const auto& record) {
    std::array<Word, std::decay_t<decltype(record)>::size> w{};
    for_each_member<std::decay_t<decltype(record)>>(
        [&](auto member, std::size_t i) { w[i] = (record.*member).word; });
    return w;
  };
  typename Design::template Inputs<Word> in;
  typename Design::template Outputs<Word> seen{};
  std::uint64_t clocks = 0;
  for (; hostile.next(in, seen); ++clocks) {
    const auto strict_in =
        converted<typename Design::template Inputs<Strict>>(in, [](Word w) { return Strict(w); });
    const auto step = Design::next(p, state, strict_in);
    ASSERT_EQ(words(Design::registers(p, state)), register_words(machine));
    seen = machine.clock(in);
    ASSERT_EQ(words(step.outputs), to_words(seen)) << "clock " << clocks;
    ASSERT_EQ(words(step.state), to_words(machine.state)) << "clock " << clocks;
    state = step.state;
  }
  EXPECT_EQ(clocks, kClocks);
}

template <class Design>
void expect_lanes_step(const typename Design::Params& p) {
  using Inputs = typename Design::template Inputs<Word>;
  std::vector<HostileStimulus<Design>> hostile;
  std::vector<ModelMachine<Design>> machines(kLanes, ModelMachine<Design>(p));
  for (std::size_t i = 0; i < kLanes; ++i) hostile.push_back(stimulus<Design>(p, i + 1));

  auto state = reset_state_of<Design, Lanes>(p);
  const auto words_of_lane = [](const auto& record, std::size_t i) {
    std::array<Word, std::decay_t<decltype(record)>::size> w{};
    for_each_member<std::decay_t<decltype(record)>>(
        [&](auto member, std::size_t m) { w[m] = (record.*member).lane[i]; });
    return w;
  };
  std::uint64_t clocks = 0;
  for (;; ++clocks) {
    std::array<Inputs, kLanes> in;
    bool more = true;
    for (std::size_t i = 0; i < kLanes; ++i) more = hostile[i].next(in[i], {}) && more;
    if (!more) break;
    typename Design::template Inputs<Lanes> lanes_in;
    for_each_member<Inputs>([&](auto member, std::size_t m) {
      lanes_in.*(decltype(lanes_in)::members()[m]) =
          Lanes(each_lane([&](std::size_t i) { return in[i].*member; }));
    });
    const auto step = Design::next(p, state, lanes_in);
    const auto registers = Design::registers(p, state);
    for (std::size_t i = 0; i < kLanes; ++i) {
      ASSERT_EQ(words_of_lane(registers, i), register_words(machines[i]));
      const auto seen = machines[i].clock(in[i]);
      ASSERT_EQ(words_of_lane(step.outputs, i), to_words(seen)) << "lane " << i;
      ASSERT_EQ(words_of_lane(step.state, i), to_words(machines[i].state)) << "lane " << i;
    }
    state = step.state;
  }
  EXPECT_EQ(clocks, kClocks);
}

template <class Design>
class ValueTypes : public testing::Test {};
TYPED_TEST_SUITE(ValueTypes, Designs, DesignNames);

// A struct is no template over its values.
template <class Design>
inline constexpr bool takes_any_value = !requires {
  typename Design::First;
};

TYPED_TEST(ValueTypes, StrictStepsAsWordsDo) {
  if constexpr (takes_any_value<TypeParam>) {
    for_each_shape<TypeParam>(expect_strict_steps<TypeParam>);
  }
}
TYPED_TEST(ValueTypes, EightLanesStepAsEightMachines) {
  if constexpr (takes_any_value<TypeParam>) {
    for_each_shape<TypeParam>(expect_lanes_step<TypeParam>);
  }
}

}  // namespace
}  // namespace cosim::test
