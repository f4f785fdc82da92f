// A golden model one clock at a time, its pins in the test's hands.
#pragma once

#include "model/core/fields.h"

namespace cosim::test {

template <class Design>
class ModelMachine {
 public:
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  using Registers = typename Design::template Registers<Word>;

  explicit ModelMachine(const typename Design::Params& p)
      : state(reset_state_of<Design, Word>(p)), p_(p) {}

  /// The outputs during the clock; the registers and the state then are those behind it.
  Outputs clock(const Inputs& in) {
    const auto step = Design::next(p_, state, in);
    state = step.state;
    return step.outputs;
  }
  Registers registers() const { return Design::registers(p_, state); }

  typename Design::template State<Word> state;

 private:
  typename Design::Params p_;
};

/// As arrays of words, for EXPECT_EQ to compare and print.
template <class Design>
auto register_words(const ModelMachine<Design>& machine) {
  return to_words(machine.registers());
}

}  // namespace cosim::test
