// The circular machine's pins and registers, tied to the Verilated class by the model's field
// tables.
#pragma once

#include "model/circular/bins.h"
#include "model/circular/host.h"
#include "model/circular/machine.h"
#include "tb/adapter.h"

namespace cosim::circular {

template <class Top, Params P>
class Adapter : public VerilatedInstance<Top> {
 public:
  using Design = circular::Design;
  static constexpr Params params = P;
  static constexpr const auto& bins = circular::bins;
  using VerilatedInstance<Top>::VerilatedInstance;

  void drive(const Inputs<Word>& in) {
#define DRIVE(name, width, format, source, meaning) this->set(this->top().name, in.name);
    CIRCULAR_INPUTS(DRIVE)
#undef DRIVE
  }

  Outputs<Word> outputs() const {
#define READ(name, width, format, source, meaning) this->get(this->top().name),
    return {CIRCULAR_OUTPUTS(READ)};
#undef READ
  }

  Registers<Word> registers() const {
#define READ(name, width, format, source, meaning) \
  this->get(this->top().rootp->circular__DOT__##name##_q),
    return {CIRCULAR_REGISTERS(READ)};
#undef READ
  }
};

}  // namespace cosim::circular
