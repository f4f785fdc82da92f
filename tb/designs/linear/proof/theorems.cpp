#include "tb/designs/linear/proof/theorems.h"

namespace cosim::linear {

std::vector<proof::Theorem> theorems() { return proof::joined({code_theorems(), word_theorems()}); }

}  // namespace cosim::linear
