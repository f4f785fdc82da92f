// The old RTL and the new one side by side, as one graph with one output.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "tb/equiv/equiv.h"
#include "tb/proof/aig.h"

namespace cosim::equiv {

struct Product {
  proof::Aig graph;
  proof::Aig::Lit bad = 0;                     ///< an output differs
  std::map<Name, proof::Aig::Lit> inputs;      ///< as both get them
  std::map<std::string, int> widths;           ///< of the inputs
  std::map<Name, proof::Aig::Lit> gold, gate;  ///< the outputs that are compared, by the old names
  std::map<Name, proof::Aig::Lit> any;         ///< the old RTL says x
  std::size_t matched = 0;                     ///< registers that both have by name
  bool alone_any = false;  ///< the old RTL has a register without initial value that no other has
};

/// How the registers of both stand.
enum class Registers {
  two,  ///< from their initial values on
  /// Those that both have by name and begin alike are one, any state is the first, and `bad` is
  /// also that the two would make it differ. If that is never, the RTLs are equal.
  one,
};

/// What the old RTL's x is.
enum class Unknown {
  same,  ///< what the new RTL's is where they have as many, else 0: one of its values
  any,   ///< all values: an output that depends on it is `any`
};

Product product_of(const Question& question, Registers registers, Unknown unknown);

}  // namespace cosim::equiv
