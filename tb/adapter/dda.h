// The DDA's pins and registers, tied to the Verilated class by the model's field tables.
#pragma once

#include "model/dda/bins.h"
#include "model/dda/host.h"
#include "model/dda/machine.h"
#include "tb/adapter.h"

namespace cosim::dda {

template <class Top, Params P>
class Adapter : public VerilatedInstance<Top> {
 public:
  using Design = dda::Design;
  static constexpr Params params = P;
  static constexpr const auto& bins = dda::bins;
  using VerilatedInstance<Top>::VerilatedInstance;

  void drive(const Inputs<Word>& in) {
#define DRIVE(name, width, format, source, meaning) this->set(this->top().name, in.name);
    DDA_INPUTS(DRIVE)
#undef DRIVE
  }

  Outputs<Word> outputs() const {
#define READ(name, width, format, source, meaning) this->get(this->top().name),
    return {DDA_OUTPUTS(READ)};
#undef READ
  }

  Registers<Word> registers() const {
#define READ(name, width, format, source, meaning) \
  this->get(this->top().rootp->dda__DOT__##name##_q),
    return {DDA_REGISTERS(READ)};
#undef READ
  }
};

}  // namespace cosim::dda
