// What registers() rests on: whatever the pins do, the state stays one that the RTL's registers can
// hold.
#pragma once

#include <gtest/gtest.h>

#include "tb/sim/hostile.h"
#include "tests/support/model_machine.h"
#include "tests/support/shape.h"

namespace cosim::test {

template <class Record, class Params>
void expect_fits(const Record& record, const Params& p) {
  const auto words = to_words(record);
  const auto fields = Record::fields(p);
  for (std::size_t i = 0; i < words.size(); ++i) {
    ASSERT_EQ(words[i], cosim::low_bits(words[i], fields[i].width)) << fields[i].name;
  }
}

/// What a design states of its state, in model/NAME/stated.h.
template <class Params, class State>
void expect_stated(const Params& p, const State& s) {
  for (const auto& [sentence, holds] : invariant_of<Word>(p, s)) ASSERT_TRUE(holds) << sentence;
  for (const auto& [sentence, holds] : reached_of<Word>(p, s)) ASSERT_TRUE(holds) << sentence;
}

/// Hostile clocks on the model in each of its shapes: all that it shows fits its fields.
/// `recovered(params, state)` expects that every number of the state comes back from its code in
/// the registers.
template <class Design, class Recovered>
void expect_states_fit_the_registers(Recovered recovered) {
  constexpr std::uint64_t cases = 200, length = 1000;
  for_each_shape<Design>([&](const typename Design::Params& p) {
    std::uint64_t clocks = 0, busy = 0;
    for (std::uint64_t i = 0; i < cases; ++i) {
      HostileStimulus<Design> hostile(p, {11, i, length});
      ModelMachine<Design> machine(p);
      typename Design::template Inputs<Word> in;
      typename Design::template Outputs<Word> seen{};
      for (; hostile.next(in, seen); ++clocks) {
        expect_fits(in, p);
        seen = machine.clock(in);
        expect_fits(seen, p);
        expect_fits(machine.registers(), p);
        recovered(p, machine.state);
        expect_stated(p, machine.state);
        if (testing::Test::HasFatalFailure()) {
          FAIL() << "case " << i << " clock " << clocks % length;
        }
        busy += to_words(seen)[0] != 0;  // busy, running
      }
    }
    EXPECT_EQ(clocks, cases * length);
    EXPECT_GT(busy, clocks / 200);  // the machine was at work, too
  });
}

}  // namespace cosim::test
