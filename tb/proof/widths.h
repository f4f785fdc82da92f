// A theorem on a design's model at every width that is shipped.
#pragma once

#include "model/core/fields.h"
#include "tb/proof/bits.h"
#include "tb/proof/theorems.h"

namespace cosim::proof {

/// The values of a machine's parameters, in its own order.
using Widths = std::vector<Parameter>;

/// What is assumed, and what must not be.
struct Asked {
  Script script;
  Truth wrong;
};

Theorem at_every_width(const std::string& design, const std::string& sentence,
                       Asked (*ask)(const Widths&));

/// A free number of `width` bits, without a sign or in two's complement.
BitVector free_number(Script& script, const std::string& name, int width);
BitVector free_signed(Script& script, const std::string& name, int width);

}  // namespace cosim::proof
