#include "tb/designs/circular/proof/theorems.h"

namespace cosim::circular {

std::vector<proof::Theorem> theorems() {
  return proof::joined({circle_theorems(), arc_theorems()});
}

}  // namespace cosim::circular
