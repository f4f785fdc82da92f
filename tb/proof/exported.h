// Golden models as their exporters wrote them, as formulas on words.
#pragma once

#include <string>
#include <vector>

#include "model/clocked/design.h"
#include "tb/proof/bits.h"

namespace cosim::clocked {

template <>
struct SymbolsOf<proof::BitVector> {
  /// As those of nets::Number (tb/nets/exported.h). A number of more than 64 bits is refused.
  static void give(const Asked<proof::BitVector>& asked, const std::string& section,
                   std::vector<SymbolCell<proof::BitVector>>& wanted);
};

}  // namespace cosim::clocked
