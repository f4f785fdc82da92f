// A golden model as formulas: one clock from any state, under any inputs.
#pragma once

#include "tb/nets/machine.h"
#include "tb/proof/bits.h"
#include "tb/proof/terms.h"

namespace cosim::proof {

using MachineFormula = nets::MachineOf<Bits>;
using Wire = MachineFormula::Wire;
using Named = MachineFormula::Named;

/// What is wrong with a wire, where it is compared.
inline Expression where_compared(const Wire& w, const Expression& wrong) {
  return w.when ? conjunction(*w.when, wrong) : wrong;
}

/// The symbol of a cell.
inline Expression symbol(const char* kind, const Field& f) {
  return {term_of(kind, f), bit_vector(f.width)};
}

/// The formulas of one design at the parameters p.
template <class Design>
MachineFormula formula(const typename Design::Params& p) {
  const auto number = [](const Field& f) {
    const Expression e = symbol("state", f);
    return nets::FreeOf<Bits>{
        is_signed(f) ? Bits::signed_code(e, f.width) : Bits::unsigned_code(e, f.width), e};
  };
  const auto code = [](const Field& f) {
    const Expression e = symbol("in", f);
    return nets::FreeOf<Bits>{Bits::unsigned_code(e, f.width), e};
  };
  return nets::machine_of<Design, Bits>(p, number, code);
}

}  // namespace cosim::proof
