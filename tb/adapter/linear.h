// The linear machine's pins and registers, tied to the Verilated class by the model's field tables.
#pragma once

#include "model/linear/bins.h"
#include "model/linear/host.h"
#include "model/linear/machine.h"
#include "tb/adapter.h"

namespace cosim::linear {

template <class Top, Params P>
class Adapter : public VerilatedInstance<Top> {
 public:
  using Design = linear::Design;
  static constexpr Params params = P;
  static constexpr const auto& bins = linear::bins;
  using VerilatedInstance<Top>::VerilatedInstance;

  void drive(const Inputs<Word>& in) {
#define DRIVE(name, width, format, source, meaning) this->set(this->top().name, in.name);
    LINEAR_INPUTS(DRIVE)
#undef DRIVE
  }

  Outputs<Word> outputs() const {
#define READ(name, width, format, source, meaning) this->get(this->top().name),
    return {LINEAR_OUTPUTS(READ)};
#undef READ
  }

  Registers<Word> registers() const {
#define READ(name, width, format, source, meaning) \
  this->get(this->top().rootp->linear__DOT__##name##_q),
    return {LINEAR_REGISTERS(READ)};
#undef READ
  }
};

}  // namespace cosim::linear
